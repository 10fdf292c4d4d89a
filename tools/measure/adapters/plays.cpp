/// An adapter plays motions and hard cases, as the engines of ../peers do.
#include <fmt/format.h>

#include <algorithm>

#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/adapters/adapter.h"
#include "pushback/tools/measure/peers/peer.h"
#include "pushback/tools/measure/study/every_motion.h"

namespace pushback {

namespace {

/// A motion's 1/60 s is one question: what the question costs is in no time.
class AskedForMotion : public Player {
 public:
  AskedForMotion(const Motion& motion, const Setting& setting, const std::string& name)
      : adapter_(the_adapter()), h_(static_cast<Real>(setting.dt())) {
    World world;
    motion.begin(world);
    for (const Body& body : world.bodies) places_.push_back(body.position.cast<double>());
    const std::string lacks = adapter_.open(name, setting.substeps, setting.sweeps, h_, world);
    if (!lacks.empty()) throw not_had(lacks);
    keep(adapter_.step(0, h_));
  }
  void frame(int substeps) override {
    const Adapter::Moved moved = adapter_.step(substeps, h_);
    seconds_ += moved.seconds;
    keep(moved);
  }
  Eigen::Vector3d place(std::size_t body) const override { return places_[body]; }
  std::optional<double> seconds() const override { return seconds_; }

 private:
  void keep(const Adapter::Moved& moved) {
    for (const Body& body : moved.bodies) places_[static_cast<std::size_t>(body.index)] = body.position.cast<double>();
  }

  Adapter& adapter_;
  Real h_;
  Places places_;
  double seconds_ = 0;
};

/// A world of a hard case. A body that is put anew, or driven, is handed on with the next step.
class AskedForWorld : public Engine {
 public:
  AskedForWorld(const World& world, const PeerSetting& setting) : adapter_(the_adapter()), states_(world.bodies) {
    // The length of its steps comes with each of them: a hard case changes it.
    const std::string lacks = adapter_.open(setting.name, setting.substeps, setting.sweeps, 0, world);
    if (!lacks.empty()) throw not_had(lacks);
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
  void step(double h) override {
    for (const Body& body : adapter_.step(1, static_cast<Real>(h), changed_, pushed_).bodies)
      states_[static_cast<std::size_t>(body.index)] = body;
    changed_.clear();
    pushed_.clear();
  }

 private:
  Adapter& adapter_;
  std::vector<Body> states_, changed_, pushed_;
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
  for (const PeerSetting& setting : the_adapter().settings())
    methods.push_back(
        {.name = setting.name,
         .title = setting.what,
         .plays = [name = setting.name](const Motion& motion) { return plays(motion, name); },
         .begin = [name = setting.name](const Motion& motion, const Setting& how) -> std::unique_ptr<Player> {
           return std::make_unique<AskedForMotion>(motion, how, name);
         },
         .sweeps = the_adapter().sweeps(setting.name)});
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
  return std::make_unique<AskedForWorld>(world, setting);
}

}  // namespace pushback
