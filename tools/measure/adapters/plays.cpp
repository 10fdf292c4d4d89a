/// An adapter plays motions and hard cases, as the engines of ../peers do.
#include <fmt/format.h>

#include <algorithm>

#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/adapters/adapter.h"
#include "pushback/tools/measure/peers/peer.h"
#include "pushback/tools/measure/study/every_motion.h"

namespace pushback {

namespace {

/// What is put anew, driven or pushed is handed on with the next question. So many steps are one question: a motion's 1/60 s is one.
class AskedEngine final : public Engine {
 public:
  /// `dt`: the length of a substep, s; 0: it comes with each step, since a hard case changes it.
  AskedEngine(const World& world, const std::string& setting, int substeps, int sweeps, double dt)
      : adapter_(the_adapter()), states_(world.bodies) {
    const std::string lacks = adapter_.open(setting, substeps, sweeps, static_cast<Real>(dt), world);
    if (!lacks.empty()) throw not_had(lacks);
    if (dt > 0) steps(0, dt);  // where it says that they are
  }
  void put(const Body& body) override {
    states_[static_cast<std::size_t>(body.index)] = body;
    changed_.push_back(body);
  }
  void get(Body& body) const override {
    const Body& moved = states_[static_cast<std::size_t>(body.index)];
    body.position = moved.position;
    body.orientation = moved.orientation;
    body.velocity = moved.velocity;
    body.angular_velocity = moved.angular_velocity;
  }
  void drive(const Body& now, const Body&) override { changed_.push_back(now); }
  void push(const Body& body) override {
    if (!body.force.isZero(0) || !body.torque.isZero(0)) pushed_.push_back(body);
  }
  void step(double h) override { steps(1, h); }
  void steps(int count, double h) override {
    const Adapter::Moved moved = adapter_.step(count, static_cast<Real>(h), changed_, pushed_);
    for (const Body& body : moved.bodies) states_[static_cast<std::size_t>(body.index)] = body;
    seconds_ += count > 0 ? moved.seconds : 0;
    changed_.clear();
    pushed_.clear();
  }
  std::optional<double> seconds() const override { return seconds_; }

 private:
  Adapter& adapter_;
  std::vector<Body> states_, changed_, pushed_;
  double seconds_ = 0;
};

/// Whether it says so, asked for the motion in its plainest form. The question has no words for a conveyor.
bool plays(const Motion& motion, const std::string& setting) {
  if (has_conveyor(motion)) return false;
  World world;
  motion.begin(world);
  return the_adapter().open(setting, 1, 1, Real(1) / frames_per_second, world).empty();
}

}  // namespace

std::vector<Method> peer_methods() {
  std::vector<Method> methods;
  for (const PeerSetting& setting : the_adapter().settings()) {
    const std::string& name = setting.name;
    methods.push_back(method_of(name, setting.what, [name](const World& world, const Setting& how) {
      return std::make_unique<AskedEngine>(world, name, how.substeps, how.sweeps, how.dt());
    }));
    methods.back().plays = [name](const Motion& motion) { return plays(motion, name); };
    methods.back().sweeps = the_adapter().sweeps(name);
  }
  return methods;
}

std::string peer_version() {
  try {
    return fmt::format("{}, through a pipe", the_adapter().engine());
  } catch (const std::exception& problem) {  // who needs more than its name says so with the right exit status
    return problem.what();
  }
}

std::vector<PeerSetting> settings_of_peer() {
  return the_adapter().settings();
}

std::unique_ptr<Engine> begin_engine(const World& world, const PeerSetting& setting) {
  return std::make_unique<AskedEngine>(world, setting.name, setting.substeps, setting.sweeps, 0);
}

}  // namespace pushback
