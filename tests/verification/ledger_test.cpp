// The balance sees a broken kernel: the books of each channel are kept from its own force and
// velocity, so a force that nobody books (here a kernel's forces, changed on purpose by 2 %) opens
// a gap between the columns, and the run stops. And a run that breaks says where.
#include <gtest/gtest.h>

#include <limits>

#include "core/errors.hpp"
#include "tests/support/simulate.hpp"

namespace brunt::test {
namespace {

const char* const kCube = R"(
title: a cube thrown at a wall
geometry: 3d
time: {end: 60 us, safety: 0.9, max_drift: 0.01}
materials:
  steel: {density: 7850 kg/m^3, elastic: {E: 200 GPa, nu: 0.3}}
bodies:
  cube:
    method: fe
    material: steel
    shape: {box: {min: [0, 0, 0.1 mm], max: [10 mm, 10 mm, 10.1 mm]}}
    size: 2 mm
    velocity: [0, 0, -50 m/s]
  wall: {method: fe, rigid: true, shape: {plane: {origin: [0, 0, 0], normal: z, extent: 40 mm}}}
output: {history: 1 us}
)";

/// A solid whose internal forces come out wrong by a factor; all else is the solid's own.
class Broken final : public Solid<3> {
 public:
  Broken(std::unique_ptr<Solid<3>> solid, Real factor) : solid_(std::move(solid)), by_(factor) {}
  std::unique_ptr<Solid<3>> part(const Partition&, const Communicator&) const override {
    return {};
  }
  void save_state(std::vector<StateTable>& tables) const override { solid_->save_state(tables); }
  void load_state(const StateTables& tables) override { solid_->load_state(tables); }
  const GhostPlan& ghosts() const override { return solid_->ghosts(); }
  Points<3>& points() override { return solid_->points(); }
  const Points<3>& points() const override { return solid_->points(); }
  Surface<3>& surface() override { return solid_->surface(); }
  void update_state(Real dt) override { solid_->update_state(dt); }
  void add_internal_forces(Real dt) override {
    auto& f = solid_->points().f;
    const auto before = f;
    solid_->add_internal_forces(dt);
    for (std::size_t i = 0; i < f.size(); ++i) f[i] = before[i] + by_ * (f[i] - before[i]);
  }
  StepLimit stable_step() const override { return solid_->stable_step(); }
  void rearrange() override { solid_->rearrange(); }
  void renew_lists() override { solid_->renew_lists(); }
  void add_totals(Totals<3>& totals) const override { solid_->add_totals(totals); }
  void check(Real time, const std::vector<std::string>& names) const override {
    solid_->check(time, names);
  }
  BodyView view(Label body, const WantedFields& wanted) const override {
    return solid_->view(body, wanted);
  }
  std::size_t n_elements() const override { return solid_->n_elements(); }
  std::size_t n_particles() const override { return solid_->n_particles(); }
  std::vector<Real> point_work() const override { return solid_->point_work(); }

 private:
  std::unique_ptr<Solid<3>> solid_;
  Real by_;
};

SceneHooks broken_by(Real factor) {
  SceneHooks hooks;
  hooks.built = [factor](Scene<3>& scene) {
    for (auto& solid : scene.solids) solid = std::make_unique<Broken>(std::move(solid), factor);
  };
  return hooks;
}

class Ledger : public ::testing::TestWithParam<const char*> {};

TEST_P(Ledger, ShowsAKernelThatIsBrokenOnPurpose) {
  const std::vector<std::string> method = {std::string("bodies.cube.method=") + GetParam()};
  const auto sound = simulate_text(kCube, method, {}, broken_by(1));
  EXPECT_EQ(sound.failure, "");
  EXPECT_LT(sound.worst_drift, 1e-12);
  const auto broken = simulate_text(kCube, method, {}, broken_by(1.05));
  EXPECT_NE(broken.failure.find("energy drift"), std::string::npos) << broken.failure;
  EXPECT_GT(broken.worst_drift, 0.01);
}
INSTANTIATE_TEST_SUITE_P(Methods, Ledger, ::testing::Values("fe", "sph"));

/// What a run says when a hook spoils the scene one step before the state is checked.
std::string failure_of(const std::string& method, const std::function<void(Points<3>&)>& spoil) {
  SceneHooks hooks;
  hooks.step_done = [&](Scene<3>& scene, const Clock& clock) {
    if (clock.step() == 99) spoil(scene.solids.front()->points());
  };
  return simulate_text(kCube, {"bodies.cube.method=" + method, "time.max_drift=1000"}, {}, hooks)
      .failure;
}

TEST(BrokenRun, NamesTheBodyAndThePointThatIsNoNumber) {
  for (const char* method : {"fe", "sph"}) {
    const auto failure = failure_of(
        method, [](Points<3>& points) { points.v[7][1] = std::numeric_limits<Real>::quiet_NaN(); });
    EXPECT_NE(failure.find("cube"), std::string::npos) << failure;
    EXPECT_NE(failure.find("finite"), std::string::npos) << failure;
  }
}

TEST(BrokenRun, NamesTheElementThatIsTurnedInsideOut) {
  const auto failure = failure_of("fe", [](Points<3>& points) {
    points.x[points.x.size() / 2][2] += 20e-3;  // a corner takes a quarter of that off 2 mm
  });
  EXPECT_NE(failure.find("cube"), std::string::npos) << failure;
  EXPECT_NE(failure.find("element"), std::string::npos) << failure;
  EXPECT_NE(failure.find("inside out"), std::string::npos) << "said: " << failure;
}

// A force along the radius on a whole side pulls at its node on the axis too, which cannot follow:
// the axis keeps its five nodes, and the balance closes to rounding.
TEST(AxisOfSymmetry, KeepsItsNodesUnderARadialForce) {
  const auto run = simulate_text(R"(
title: a disc pulled outwards at its upper side
geometry: axisymmetric
time: {end: 2 ms}
materials: {rubber: {density: 1000 kg/m^3, elastic: {E: 1 MPa, nu: 0.3}}}
bodies:
  disc: {material: rubber, shape: {box: {min: [0, 0], max: [10 mm, 10 mm]}}, cells: [4, 4]}
boundaries: {pull: {body: disc, where: {side: max-y}, force: [1 N, 1 N]}}
)");
  ASSERT_EQ(run.failure, "");
  EXPECT_LT(run.worst_drift, 1e-12);
  const auto& position = run.bodies.at("disc").position;
  int on_axis = 0;
  for (std::size_t i = 0; i < position.size(); i += 3) on_axis += position[i] == 0 ? 1 : 0;
  EXPECT_EQ(on_axis, 5);
}

}  // namespace
}  // namespace brunt::test
