/// Lists of choices: every value has one name, and names lead back to their values.
#include "core/choices/choice.h"

#include <gtest/gtest.h>

#include <set>

#include "core/choices/body_choices.h"
#include "core/choices/contact_choices.h"
#include "core/choices/fracture_choices.h"
#include "core/choices/ice_choices.h"
#include "core/choices/law.h"
#include "core/choices/output_choices.h"
#include "core/choices/solver_name.h"
#include "core/choices/vessel_choices.h"

namespace nilas {
namespace choice_test {

template <class Enum>
class EachChoice : public testing::Test {};

using Lists = testing::Types<BalanceKind, BendingModel, CarriageStart, ContactPreset, CrackPathKind, CrushingModel,
                             Detection, FieldKind, FloeProperty, FloeShape, HullKind, Integrator, JointAxis, JointKind,
                             Law, NarrowPhase, OnFailure, RampShape, SizeDistribution, SmallPieces, SolidShapeKind,
                             SolverName, SplittingModel, SpreadKind, Stabilisation, StoredContacts, StoredProblems>;
TYPED_TEST_SUITE(EachChoice, Lists);

TYPED_TEST(EachChoice, HasNamesOfItsOwn) {
  std::set<std::string> names;
  for (const TypeParam value : all_choices<TypeParam>()) {
    EXPECT_TRUE(names.insert(name_of(value)).second) << name_of(value);
    EXPECT_EQ(find_choice<TypeParam>(name_of(value)), value);
    EXPECT_EQ(choice_named<TypeParam>(name_of(value)), value);
    const ChoiceText text = choice_text(value);
    EXPECT_TRUE(text.old_name.empty() || !find_choice<TypeParam>(text.old_name)) << text.old_name;
    EXPECT_TRUE(text.doc.empty() || text.doc.ends_with('.')) << text.doc;
  }
  EXPECT_FALSE(names.empty());
  EXPECT_EQ(find_choice<TypeParam>(""), std::nullopt) << "what has no name cannot be asked for";
  EXPECT_THROW(choice_named<TypeParam>("nonsense"), ContractError);
}

TEST(Choice, AValueWithoutANameEndsTheList) {
  EXPECT_EQ(choice_names<FloeShape>().back(), "disc");
  EXPECT_EQ(name_of(FloeShape::library), "");
}

TEST(ParsedLaw, IsNamedAsItIsAskedFor) {
  for (const char* name : {"coulomb", "ccp", "pyramid", "pyramid-3", "pyramid-1000", "frictionless"})
    EXPECT_EQ(name_of(parse_law(name)), name);
}

TEST(SolverFacts, SayWhatIsTakenInstead) {
  EXPECT_EQ(law_problem(SolverName::nsgs, Law::pyramid_k), std::nullopt);
  EXPECT_EQ(*law_problem(SolverName::admm, Law::pyramid),
            "solver 'admm' does not take the law 'pyramid'; it takes: coulomb, ccp, frictionless; solvers for this "
            "law: pgs, nsgs, newton, auto");
  EXPECT_EQ(moment_problem(SolverName::automatic, Law::coulomb), std::nullopt);
  EXPECT_EQ(*moment_problem(SolverName::newton, Law::coulomb),
            "solver 'newton' does not take rolling and spinning friction; these do: nsgs, auto");
  EXPECT_NE(moment_problem(SolverName::nsgs, Law::ccp), std::nullopt);
}

}  // namespace choice_test
}  // namespace nilas
