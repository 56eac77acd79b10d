#pragma once
/// The families of cases, each of which has a file of its own.
#include <string>
#include <vector>

#include "apps/verify/case.h"

namespace nilas::verify {

std::vector<Case> point_friction();
std::vector<Case> rolling();
std::vector<Case> free_bodies();
std::vector<Case> statics();
std::vector<Case> impacts();
std::vector<Case> floating();
std::vector<Case> invariances();
std::vector<Case> crushing();
std::vector<Case> water();

/// Collects the cases of a family.
class FamilyOfCases {
 public:
  FamilyOfCases(char family, std::string scene, std::string source)
      : family_(family), scene_(std::move(scene)), source_(std::move(source)) {}

  /// Adds a case with the family's scene and source and returns it, so that the caller can set what differs. The
  /// reference is valid until the next case is added.
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

}  // namespace nilas::verify
