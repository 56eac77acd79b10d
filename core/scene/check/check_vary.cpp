#include <map>
#include <set>

#include "core/choices/ice_choices.h"
#include "core/scene/check/cross_checks.h"
#include "core/scene/schema/attribute_values.h"
#include "core/scene/spec/values.h"

namespace nilas::scene {

namespace {

/// Checks all <vary> of a scene: each property at most once, and their correlations.
class VaryCheck {
 public:
  VaryCheck(const SceneElement& ice, std::vector<Fault>& faults) : faults_(faults) {
    for (const auto& child : ice.children)
      if (child.name == "vary") add(child);
    matrix_ = MatX::Identity(static_cast<Eigen::Index>(place_.size()), static_cast<Eigen::Index>(place_.size()));
  }

  void check() {
    for (const auto* vary : varies_) {
      check_distribution(*vary);
      check_partners(*vary);
    }
    check_matrix();
  }

 private:
  void add(const SceneElement& vary) {
    const auto property = text_of(vary, "property");
    if (!property) return;
    const auto [known, is_new] = of_property_.emplace(*property, &vary);
    if (!is_new) {
      faults_.push_back(fault_of(vary, "property",
                                 "'" + *property + "' varies already by the element of line " +
                                     std::to_string(known->second->place.line) + "; allowed: one <vary> per property"));
      return;
    }
    place_.emplace(*property, static_cast<Eigen::Index>(place_.size()));
    varies_.push_back(&vary);
  }

  void check_distribution(const SceneElement& vary) {
    const auto property = choice_of<FloeProperty>(vary, "property");
    const bool is_strength = property != FloeProperty::thickness && property != FloeProperty::density;
    if (choice_of<SpreadKind>(vary, "distribution") == SpreadKind::weibull && !is_strength)
      faults_.push_back(fault_of(vary, "distribution",
                                 "found 'weibull' for " + name_of(*property) +
                                     "; allowed: normal, lognormal, uniform (weibull is for strengths)"));
  }

  void check_partners(const SceneElement& vary) {
    const auto is_faulty = [&](const char* name) { return is_named(vary, name) && !text_of(vary, name); };
    if (is_faulty("with") || is_faulty("correlation")) return;
    const auto partners = words_of(vary, "with");
    const auto correlations = numbers_of(vary, "correlation").value_or(std::vector<double>{});
    if (partners.size() != correlations.size()) {
      faults_.push_back(fault_of(vary, "correlation",
                                 "found " + std::to_string(correlations.size()) + " numbers and " +
                                     std::to_string(partners.size()) + " properties in 'with'; allowed: one for each"));
      return;
    }
    for (std::size_t k = 0; k < partners.size(); ++k) check_pair(vary, partners[k], correlations[k]);
  }

  void check_pair(const SceneElement& vary, const std::string& partner, double correlation) {
    const std::string property = *text_of(vary, "property");
    const auto refuse = [&](const char* attribute, const std::string& message) {
      faults_.push_back(fault_of(vary, attribute, message));
    };
    if (partner == property) return refuse("with", "found the property itself; allowed: other properties");
    const auto other = of_property_.find(partner);
    if (other == of_property_.end())
      return refuse("with", "'" + partner + "' does not vary; allowed: properties with a <vary> of their own");
    if (!pairs_.insert(std::minmax(property, partner)).second)
      return refuse("with", "the pair with '" + partner + "' is already named; allowed: once, at either of them");
    if (number_of(vary, "correlation_length") != number_of(*other->second, "correlation_length"))
      return refuse("correlation_length", "it differs from that of '" + partner +
                                              "', which this is correlated with; allowed: one and the same, or none "
                                              "for both");
    const Eigen::Index i = place_[property], j = place_[partner];
    matrix_(i, j) = matrix_(j, i) = correlation;
    last_ = &vary;
  }

  /// Checks the matrix of all correlations: pairs that are valid alone may be impossible together.
  void check_matrix() {
    if (!last_ || Eigen::LLT<MatX>(matrix_).info() == Eigen::Success) return;
    faults_.push_back(fault_of(*last_, "correlation",
                               "found " + *text_of(*last_, "correlation") +
                                   ", which no properties can have together with the other correlations (pairs that "
                                   "are not named have 0); allowed: a positive definite matrix of them all"));
  }

  std::vector<Fault>& faults_;
  std::vector<const SceneElement*> varies_;
  std::map<std::string, const SceneElement*> of_property_;
  std::map<std::string, Eigen::Index> place_;  ///< row in the matrix
  std::set<std::pair<std::string, std::string>> pairs_;
  MatX matrix_;
  const SceneElement* last_ = nullptr;  ///< last element that names a correlation
};

}  // namespace

void check_vary(const SceneElement& ice, std::vector<Fault>& faults) { VaryCheck(ice, faults).check(); }

}  // namespace nilas::scene
