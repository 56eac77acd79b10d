#pragma once
/// The families of cases, each in its own file.
#include <string>
#include <vector>

#include "apps/verify/case.h"

namespace nilas {

std::vector<Case> point_friction();
std::vector<Case> rolling();
std::vector<Case> free_bodies();
std::vector<Case> statics();
std::vector<Case> impacts();
std::vector<Case> floating();
std::vector<Case> invariances();
std::vector<Case> crushing();

/// Gathers a family's cases.
class FamilyOfCases {
 public:
  FamilyOfCases(char family, std::string scene, std::string source)
      : family_(family), scene_(std::move(scene)), source_(std::move(source)) {}

  /// Scene and source are the family's; whatever differs is set on what is returned, before the next is added.
  Case& operator()(int number, const std::string& title, const std::string& formula, std::vector<Input> inputs,
                   const std::string& varied, std::vector<Quantity> (*check)(const Setting&)) {
    Case one;
    one.number = number;
    one.family = family_;
    one.title = title;
    one.formula = formula;
    one.source = source_;
    one.scene = scene_;
    one.inputs = std::move(inputs);
    one.varied = varied;
    one.check = check;
    cases_.push_back(std::move(one));
    return cases_.back();
  }
  std::vector<Case> cases() const { return cases_; }

 private:
  char family_;
  std::string scene_, source_;
  std::vector<Case> cases_;
};

}  // namespace nilas
