/// The program `motion_wide`: the solvers that detect contacts once in a step play chapter 19's motions.
#include "pushback/chapters/22_wide/wide.h"
#include "pushback/tools/study/play.h"

using namespace pushback;

namespace {

/// A solver whose plan divides each step of 1/60 s.
template <class ContactSolver>
class DetectsOnce : public Player {
 public:
  DetectsOnce(const Motion& motion, const Setting& setting)
      : sweeps_(setting.sweeps), sweeps_all_(motion.pins.empty() || std::is_same_v<ContactSolver, DetectedOnce>) {
    solver_.threshold = 0;  // bounces are compared at every speed
    motion.begin(world_);
  }
  void frame(int substeps) override {
    solver_.substeps = substeps;
    const std::size_t before = rows_solved;
    world_.step(solver_, Real(1) / frames_per_second, sweeps_);
    rows_solved_ += rows_solved - before;
  }
  Eigen::Vector3d place(std::size_t body) const override {
    return world_.bodies[body].position.template cast<double>();
  }
  std::optional<double> row_solves() const override {
    if (!sweeps_all_) return {};
    return static_cast<double>(rows_solved_);
  }

 private:
  World world_;
  ContactSolver solver_;
  int sweeps_;
  bool sweeps_all_;              // joints, too
  std::size_t rows_solved_ = 0;  // by this player's steps
};

template <class ContactSolver>
Method method(const std::string& name, const std::string& title) {
  return {.name = name,
          .title = title,
          .plays = [](const Motion&) { return true; },
          .begin = [](const Motion& motion, const Setting& setting) -> std::unique_ptr<Player> {
            return std::make_unique<DetectsOnce<ContactSolver>>(motion, setting);
          }};
}

}  // namespace

int main(int argc, char** argv) {
  const std::vector<Method> methods{method<DetectedOnce>("once", "detected once"),
                                    method<Wide<double>>("wide", "detected once, wide"),
                                    method<Wide<float>>("wide-float", "detected once, wide, rows in float")};
  return play_program(argc, argv, "Plays a motion by the solvers that detect contacts once in 1/60 s.",
                      fmt::format("Pushback, contacts detected once; {}", built_by()), methods);
}
