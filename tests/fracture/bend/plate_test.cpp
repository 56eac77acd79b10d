#include "fracture/bend/plate.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/base/error.h"

namespace nilas::fracture {

/// Values computed by hand from the definitions, in metres as printed.
TEST(Plate, CharacteristicLengths) {
  const IcePlate full{1.0, 5e9}, thin{0.5, 2e9}, model{0.03, 60e6};
  EXPECT_NEAR(characteristic_length(full), 14.608, 5e-4);
  EXPECT_NEAR(beam_characteristic_length(full), 14.268, 5e-4);
  EXPECT_NEAR(characteristic_length(thin), 6.908, 5e-4);
  EXPECT_NEAR(characteristic_length(model), 0.3485, 5e-5);
}

TEST(Plate, RigidityIsLengthToTheFourthTimesTheFoundation) {
  const IcePlate plate{0.7, 3e9, 0.33, 1010};
  EXPECT_NEAR(flexural_rigidity(plate), 1010 * 9.81 * std::pow(characteristic_length(plate), 4), 1e-6);
}

TEST(Plate, PowersOfThicknessAndModulus) {
  const IcePlate plate{1, 5e9}, thick{2, 5e9}, stiff{1, 1e10};
  EXPECT_NEAR(flexural_rigidity(thick) / flexural_rigidity(plate), 8, 1e-12);
  EXPECT_NEAR(flexural_rigidity(stiff) / flexural_rigidity(plate), 2, 1e-12);
  EXPECT_NEAR(characteristic_length(thick) / characteristic_length(plate), std::pow(2, 0.75), 1e-12);
  EXPECT_NEAR(beam_characteristic_length(stiff) / beam_characteristic_length(plate), std::pow(2, 0.25), 1e-12);
}

TEST(Plate, RefusesWhatIsNoPlate) {
  EXPECT_THROW(characteristic_length({0, 5e9}), ContractError);
  EXPECT_THROW(flexural_rigidity({1, -5e9}), ContractError);
  EXPECT_THROW(beam_characteristic_length({1, 5e9, 0.6}), ContractError);
}

}  // namespace nilas::fracture
