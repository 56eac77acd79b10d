#include "core/output/replay/replay_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "core/base/error.h"
#include "tests/core/output/replay/replay_reader.h"
#include "tests/core/output/sample_run.h"
#include "tests/support/file_text.h"
#include "tests/support/refusal.h"

namespace nilas::output::replay {
namespace replay_file_test {

using test::read_text;
using test::Replay;
using test::ScratchFolder;

/// Floes of random size, place and turn, with a hull among them.
bodies::Bodies scattered(int count, std::mt19937& random) {
  std::uniform_real_distribution<double> place(-50, 50), size(1, 4), turn(-1, 1);
  bodies::Bodies bodies = test::sample_bodies();
  for (const std::size_t b : {0, 1})
    bodies.shape[b] =
        std::make_shared<const geometry::Shape>(geometry::prism_shape({Vec2(-1, -1), Vec2(1, -1), Vec2(0, 1)}, 0.2));
  for (int k = 0; k < count; ++k) {
    const double a = size(random);
    const geometry::Shape shape =
        geometry::prism_shape({Vec2(-a, -a), Vec2(a, -a), Vec2(0.5 * a, a), Vec2(-0.5 * a, a)}, 0.5);
    test::add_body(bodies, "floe", bodies::BodyKind::floe, bodies::Motion::free, shape, 100 * a,
                   Vec3(place(random), place(random), 0.1 * turn(random)));
    bodies.set_pose(bodies.size() - 1, bodies.p_GB.back(),
                    Quat(turn(random), turn(random), turn(random), turn(random)));
  }
  return bodies;
}

std::size_t place_of(const Replay& replay, const std::string& channel) {
  std::size_t place = 0;
  while (replay.head.at("channels").at(place).at("name") != channel) ++place;
  return place;
}

class ReplayFileTest : public testing::Test {
 protected:
  ReplayFileTest() {
    scene_.ice.emplace();
    record_.ledger.works = {0, 0};
    record_.vessel.reset();
    info_.has_vessel = false;
  }
  void frame(ReplayFile& file, double t) {
    record_.t = t;
    record_.step = ++step_;
    file.note(record_, {});
    file.frame({.t = t,
                .h = 0.1,
                .step = step_,
                .bodies = bodies_,
                .substeps = substeps_,
                .damage = damage_,
                .lines = lines_});
  }
  std::string text() const { return read_text(path_); }

  ScratchFolder scratch_;
  std::filesystem::path path_ = scratch_ / "replay.bin";
  scene::Scene scene_;
  sim::RunInfo info_ = test::full_run();
  sim::StepRecord record_ = test::full_record();
  std::mt19937 random_{7};
  bodies::Bodies bodies_ = scattered(40, random_);
  std::vector<contact::SolvedProblem> substeps_;
  FloeDamage damage_;
  std::vector<bodies::DrawnLine> lines_;
  long step_ = 0;
};

/// The largest distance of a point of a body from where the replay puts it, over its bounding sphere.
double distance(const bodies::Bodies& bodies, std::size_t b, const test::ReplayBody& shown) {
  const Mat3 turn = shown.q.toRotationMatrix() - bodies.R_GB[b];
  return (shown.p - bodies.p_GB[b]).norm() + turn.operatorNorm() * bodies.shape[b]->bounding_radius;
}

TEST_F(ReplayFileTest, NoPointOfAFloeIsFartherThanTheStatedErrorFromItsPlace) {
  ReplayFile file(path_, scene_, info_, {}, false);
  std::normal_distribution<double> kick(0, 0.3);
  std::vector<bodies::Bodies> truth;
  for (int k = 0; k < 150; ++k) {
    for (int b = 4; b < bodies_.size(); ++b) {
      const auto i = static_cast<std::size_t>(b);
      bodies_.v_GB[i] += Vec3(kick(random_), kick(random_), kick(random_));
      const Quat turned = bodies_.q_GB[i] * Quat(1, 0.05 * kick(random_), 0.05 * kick(random_), 0.3 * kick(random_));
      bodies_.set_pose(b, bodies_.p_GB[i] + 0.1 * bodies_.v_GB[i], turned);
    }
    frame(file, 0.1 * k);
    truth.push_back(bodies_);
  }
  file.finish("The run reached its end.");
  const Replay replay(text());
  ASSERT_EQ(replay.frames.size(), truth.size());
  EXPECT_EQ(replay.end, "The run reached its end.");
  double worst = 0;
  for (std::size_t k = 0; k < truth.size(); ++k) {
    const auto& bodies = replay.frames[k].bodies;
    ASSERT_EQ(bodies.size(), truth[k].id.size());
    EXPECT_EQ(replay.frames[k].key, k % BodyFrames::k_key_every == 0);
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      if (truth[k].kind[b] != bodies::BodyKind::floe) continue;
      worst = std::max(worst, distance(truth[k], b, bodies[b]) / (2 * truth[k].shape[b]->bounding_radius));
    }
  }
  EXPECT_LT(worst, 1e-4);
  EXPECT_GT(worst, 1e-5) << "positions are stored in few digits";
}

TEST_F(ReplayFileTest, BodiesThatComeAndGoKeepTheirIdentity) {
  ReplayFile file(path_, scene_, info_, {}, false);
  frame(file, 0);
  frame(file, 1);
  std::vector<char> gone(bodies_.id.size(), 0);
  gone[0] = gone[5] = gone[6] = gone[20] = 1;
  bodies_.remove(gone);
  test::add_body(bodies_, "piece", bodies::BodyKind::floe, bodies::Motion::free, *bodies_.shape[5], 7, Vec3(1, 2, 3));
  bodies_.id.back() = 99;
  frame(file, 2);
  frame(file, 3);
  file.finish("The run reached its end.");
  const Replay replay(text());
  ASSERT_EQ(replay.frames.size(), 4u);
  EXPECT_FALSE(replay.frames[3].key);
  for (std::size_t k = 2; k < 4; ++k) {
    const auto& shown = replay.frames[k].bodies;
    ASSERT_EQ(shown.size(), bodies_.id.size());
    for (std::size_t b = 0; b < shown.size(); ++b) {
      EXPECT_EQ(shown[b].id, bodies_.id[b]);
      EXPECT_LT((shown[b].p - bodies_.p_GB[b]).norm(), 2 * shown[b].unit);
    }
  }
  EXPECT_FLOAT_EQ(static_cast<float>(replay.frames[2].bodies.back().mass), 7);
}

TEST_F(ReplayFileTest, ASmallPieceHasAFinerUnitAndOthersKeepTheirs) {
  ReplayFile file(path_, scene_, info_, {}, false);
  frame(file, 0);
  const double before = Replay(text()).frames.back().bodies.back().unit;
  const geometry::Shape small = geometry::prism_shape({Vec2(-0.1, -0.1), Vec2(0.1, -0.1), Vec2(0, 0.1)}, 0.1);
  test::add_body(bodies_, "piece", bodies::BodyKind::floe, bodies::Motion::free, small, 1, Vec3(1, 2, 3));
  bodies_.id.back() = 500;
  frame(file, 1);
  const Replay replay(text());
  const auto& shown = replay.frames.back().bodies;
  EXPECT_FALSE(replay.frames.back().key);
  EXPECT_EQ(shown[shown.size() - 2].unit, before);
  EXPECT_FLOAT_EQ(static_cast<float>(shown.back().unit),
                  static_cast<float>(0.8e-4 * 2 * bodies_.shape.back()->bounding_radius));
  EXPECT_LT((shown.back().p - Vec3(1, 2, 3)).norm(), shown.back().unit);
}

TEST_F(ReplayFileTest, AFileOfAKilledRunIsReadUpToItsLastWholePiece) {
  ReplayFile file(path_, scene_, info_, {}, false);
  for (int k = 0; k < 3; ++k) frame(file, k);
  const std::string whole = text();
  EXPECT_EQ(Replay(whole).cut, 0u);
  const Replay cut(whole.substr(0, whole.size() - 5));
  EXPECT_EQ(cut.frames.size(), 2u);
  EXPECT_GT(cut.cut, 0u);
}

TEST_F(ReplayFileTest, AFullDiskEndsIt) {
  EXPECT_THROW(ReplayFile("/dev/full", scene_, info_, {}, false), FileError);
  std::filesystem::create_symlink("/dev/full", path_);
  EXPECT_NE(test::refusal<FileError>([&] { ReplayFile(path_, scene_, info_, {}, false); }).find("No space left"),
            std::string::npos);
}

TEST_F(ReplayFileTest, AResumedRunGoesOnInTheSameFile) {
  std::int64_t kept = 0;
  State state;
  {
    ReplayFile file(path_, scene_, info_, {}, false);
    frame(file, 0);
    kept = file.file().bytes();
    record_.contacts = 77;
    file.note(record_, {});
    file.save(StateWriter(state));
    record_.contacts = 3;
    frame(file, 1);
  }
  const StateReader from(state);
  ReplayFile file(path_, scene_, info_, {}, false, kept, &from);
  frame(file, 2);
  file.finish("The run reached its end.");
  const Replay replay(text());
  ASSERT_EQ(replay.frames.size(), 2u);
  EXPECT_EQ(replay.frames[1].t, 2);
  EXPECT_TRUE(replay.frames[1].key);
  EXPECT_EQ(replay.frames[1].channels[place_of(replay, "contacts")][2], 77) << "a peak before the checkpoint";
}

TEST_F(ReplayFileTest, TheHeadNamesWhatAViewerNeeds) {
  scene_.water.emplace();
  scene_.tank.emplace();
  scene_.view.emplace();
  const ReplayFile file(path_, scene_, info_, {}, false);
  const Replay replay(text());
  EXPECT_EQ(replay.head.at("scene"), "sample");
  EXPECT_EQ(replay.head.at("tank").at("length"), 10);
  EXPECT_EQ(replay.head.at("view").at("mesh"), "fluid");
  EXPECT_EQ(replay.head.at("hull"), nullptr);
  EXPECT_EQ(replay.head.at("contacts"), "none");
  EXPECT_EQ(replay.head.at("channels").back().at("group"), "time");
}

TEST_F(ReplayFileTest, ChannelsHaveTheirRangeBetweenFrames) {
  ReplayFile file(path_, scene_, info_, {}, false);
  for (const int contacts : {3, 9, 1, 4}) {
    record_.contacts = contacts;
    file.note(record_, {});
  }
  frame(file, 1);
  frame(file, 2);
  const Replay replay(text());
  const std::size_t place = place_of(replay, "contacts");
  EXPECT_EQ(replay.frames[0].channels[place], (std::array<float, 3>{4, 1, 9}));
  EXPECT_EQ(replay.frames[1].channels[place], (std::array<float, 3>{4, 4, 4}));
}

TEST_F(ReplayFileTest, TheRangeOfAChannelIsRoundedOutwards) {
  ReplayFile file(path_, scene_, info_, {}, false);
  std::uniform_real_distribution<double> digits(-1, 1), power(-30, 30);
  std::vector<std::array<double, 2>> ranges;
  for (int k = 0; k < 200; ++k) {
    const double a = digits(random_) * std::pow(10, power(random_)), b = digits(random_) * std::pow(10, power(random_));
    ranges.push_back({std::min(a, b), std::max(a, b)});
    record_.ledger.kinetic = ranges.back()[0];
    file.note(record_, {});
    record_.ledger.kinetic = ranges.back()[1];
    frame(file, k);
  }
  const Replay replay(text());
  for (std::size_t k = 0; k < ranges.size(); ++k) {
    const auto& shown = replay.frames.at(k).channels[place_of(replay, "kinetic")];
    for (std::size_t side = 0; side < 2; ++side) {
      const double beyond = (side == 0 ? -1 : 1) * (static_cast<double>(shown[side + 1]) - ranges[k][side]);
      const double rounding = 1e-7 * std::max(std::abs(ranges[k][0]), std::abs(ranges[k][1]));
      EXPECT_GE(beyond, -rounding);
      EXPECT_LE(beyond, std::ldexp(ranges[k][1] - ranges[k][0], -7) + rounding);
    }
  }
}

TEST_F(ReplayFileTest, AFrameBeforeTheFirstStepKnowsNoChannels) {
  ReplayFile file(path_, scene_, info_, {}, false);
  file.frame({.t = 0, .h = 0, .step = 0, .bodies = bodies_, .substeps = {}, .damage = {}, .lines = {}});
  frame(file, 1);
  const Replay replay(text());
  for (const auto& channel : replay.frames[0].channels)
    for (const float x : channel) EXPECT_TRUE(std::isnan(x));
  for (const auto& channel : replay.frames[1].channels)
    for (const float x : channel) EXPECT_TRUE(std::isfinite(x));
}

TEST_F(ReplayFileTest, LinesAndArrowsOfModulesAreShown) {
  ReplayFile file(path_, scene_, info_, {}, false);
  lines_.push_back({bodies::DrawnLine::Kind::mooring, "bow", 5e3, {Vec3(1, 2, -3), Vec3(4, 5, 0), Vec3(6, 7, 8)}});
  add_arrow(bodies::DrawnLine::Kind::thruster, "tunnel", Vec3(1, 0, 0), Vec3(0, -20, 0), lines_);
  add_arrow(bodies::DrawnLine::Kind::thruster, "idle", Vec3(1, 0, 0), Vec3::Zero(), lines_);
  frame(file, 0);
  const Replay replay(text());
  const auto& lines = replay.frames.at(0).lines;
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_EQ(lines[0].kind, 0);
  EXPECT_EQ(lines[0].name, "bow");
  EXPECT_EQ(lines[0].points, (std::vector<Vec3>{Vec3(1, 2, -3), Vec3(4, 5, 0), Vec3(6, 7, 8)}));
  EXPECT_EQ(lines[1].force, 20);
  EXPECT_EQ(lines[1].points[1], Vec3(1, -1, 0));
}

TEST(Pieces, OtherFilesAreRefused) {
  EXPECT_NE(test::refusal([] { pieces_of("no replay at all", "a.bin"); }).find("a.bin: is no replay file"),
            std::string::npos);
  EXPECT_NE(test::refusal([] { pieces_of("NILASRP1", "a.bin"); }).find("a.bin: has version 1"), std::string::npos);
  EXPECT_NE(test::refusal([] { pieces_of("NILASRP", "a.bin"); }).find("ends before its first piece"),
            std::string::npos);
  std::string bytes = std::string(k_signature) + packed_piece(k_head, "{}");
  bytes.back() = 'x';
  EXPECT_NE(test::refusal([&] { pieces_of(bytes, "a.bin"); }).find("damaged at byte 8"), std::string::npos);
  EXPECT_THROW(unpacked("this is not packed"), InputError);
}

}  // namespace replay_file_test
}  // namespace nilas::output::replay
