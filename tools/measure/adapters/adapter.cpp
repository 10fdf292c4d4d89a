#include "pushback/tools/measure/adapters/adapter.h"

#include <fmt/ranges.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <stdexcept>

#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/peers/peer.h"

namespace pushback {

std::vector<std::string> command_of_adapter(const std::filesystem::path& file) {
  if (!std::filesystem::is_regular_file(file))
    throw InvalidInput(fmt::format("adapter is '{}': the name of a file is needed", file.string()));
  const std::string full = std::filesystem::absolute(file).string(), ending = file.extension().string();
  if (ending == ".mjs" || ending == ".js") return {"node", full};
  if (ending == ".py") return {"python3", full};
  if (access(full.c_str(), X_OK) != 0)
    throw InvalidInput(
        fmt::format("adapter is '{}': a program, or a file that ends in .mjs, .js or .py, is needed", file.string()));
  return {full};
}

namespace {

[[noreturn]] void wrong(const Json& question, const std::string& needed, const Json& answer) {
  std::string said = answer.dump();
  if (said.size() > 200) said = said.substr(0, 200) + " ...";
  throw std::runtime_error(
      fmt::format("asked \"{}\", the adapter says {}: {} is needed", question["ask"].get<std::string>(), said, needed));
}

/// The field, if it is of this type.
template <class Value>
Value field(const Json& from, const char* name, const Json& question, const std::string& needed) {
  const auto found = from.find(name);
  if (found == from.end()) wrong(question, needed, from);
  try {
    return found->get<Value>();
  } catch (const Json::exception&) {
    wrong(question, needed, from);
  }
}

/// NaN where it is null: a number that was none has no other form in this text.
double number_of(const Json& json) {
  return json.is_number() ? json.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace

Adapter::Adapter(const std::filesystem::path& file) : conversation_(command_of_adapter(file)) {
  const Json question{{"ask", "settings"}};
  const std::string needed =
      R"({"engine": "its name and version", "settings": [{"name": "a word", "what": "what is set", "sweeps": true}]})";
  const Json answer = ask(question);
  engine_ = field<std::string>(answer, "engine", question, needed);
  const Json settings = field<Json>(answer, "settings", question, needed);
  if (!settings.is_array() || settings.empty()) wrong(question, needed, answer);
  for (const Json& one : settings) {
    if (!one.is_object()) wrong(question, needed, answer);
    PeerSetting setting;
    setting.name = field<std::string>(one, "name", question, needed);
    setting.what = field<std::string>(one, "what", question, needed);
    setting.engine = "adapter";
    setting.substeps = one.value("substeps", 1);
    setting.sweeps = one.value("iterations", 10);
    if (one.value("float", false)) setting.epsilon = Real(std::numeric_limits<float>::epsilon());
    if (setting.name.empty() || setting.name.find_first_of("/: \t") != std::string::npos || setting.substeps < 1 ||
        setting.sweeps < 1)
      wrong(question, needed, answer);
    settings_.push_back(setting);
    sweeps_.push_back(field<bool>(one, "sweeps", question, needed));
  }
}

Json Adapter::ask(const Json& question) {
  const std::string said = conversation_.answer(question.dump());
  const Json answer = Json::parse(said, nullptr, false);  // what cannot be read is discarded, and no object
  if (answer.is_object()) return answer;
  wrong(question, "an object in JSON, on a line", said);
}

bool Adapter::sweeps(const std::string& setting) const {
  for (std::size_t i = 0; i < settings_.size(); ++i)
    if (settings_[i].name == setting) return sweeps_[i];
  throw InvalidInput(fmt::format("the adapter has no setting '{}'", setting));
}

std::string Adapter::open(const std::string& setting, int substeps, int sweeps, Real dt, const World& world) {
  const Json question{{"ask", "open"},    {"setting", setting}, {"substeps", substeps},
                      {"sweeps", sweeps}, {"dt", dt},           {"scene", scene_json(world)}};
  const std::string needed = R"({"plays": true}, or {"plays": false, "lacks": "what it has not"},)";
  const Json answer = ask(question);
  bodies_ = world.bodies.size();
  if (field<bool>(answer, "plays", question, needed)) return "";
  return field<std::string>(answer, "lacks", question, needed);
}

Adapter::Moved Adapter::step(int steps, Real h, const std::vector<Body>& changed, const std::vector<Body>& pushed) {
  Json question{{"ask", "step"}, {"steps", steps}, {"h", h}};
  for (const Body& body : changed) question["put"].push_back(state_json(body));
  for (const Body& body : pushed)
    question["push"].push_back(
        {{"body", body.index}, {"force", json_of(body.force)}, {"torque", json_of(body.torque)}});
  const std::string needed = fmt::format(
      R"({{"seconds": of these steps, "states": [one of 13 numbers for each of the {} bodies: position, orientation as w x y z, velocity, angular velocity; or null]}})",
      bodies_);
  const auto begin = std::chrono::steady_clock::now();
  const Json answer = ask(question);
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  Moved moved{.seconds = field<double>(answer, "seconds", question, needed), .bodies = {}};
  constexpr double tick = 1e-4;  // s: clocks of other languages are coarse
  if (!(moved.seconds >= 0 && moved.seconds <= wall + tick))
    wrong(question, fmt::format("a time in seconds from 0 to {:.4g}, which is what the answer took,", wall), answer);
  const Json states = field<Json>(answer, "states", question, needed);
  if (!states.is_array() || states.size() != bodies_) wrong(question, needed, answer);
  for (std::size_t i = 0; i < bodies_; ++i) {
    if (states[i].is_null()) continue;
    if (!states[i].is_array() || states[i].size() != 13) wrong(question, needed, answer);
    const auto at = [&](std::size_t k) { return static_cast<Real>(number_of(states[i][k])); };
    Body body;
    body.index = static_cast<int>(i);
    body.position = {at(0), at(1), at(2)};
    body.orientation = Quat(at(3), at(4), at(5), at(6));
    body.velocity = {at(7), at(8), at(9)};
    body.angular_velocity = {at(10), at(11), at(12)};
    moved.bodies.push_back(body);
  }
  return moved;
}

Adapter& the_adapter() {
  const char* const file = std::getenv("PUSHBACK_ADAPTER");
  if (file == nullptr) throw InvalidInput("PUSHBACK_ADAPTER is not set: the name of a file is needed");
  static Adapter adapter(file);
  return adapter;
}

namespace {

/// An adapter plays motions and hard cases, as the engines of ../peers do. The next question contains all bodies that were put, driven
/// or pushed. 1/60 s of a motion is one question, however many steps it has.
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
    methods.push_back({.name = name,
                       .title = setting.what,
                       .plays = [name](const Motion& motion) { return plays(motion, name); },
                       .begin =
                           [name](const World& world, const Setting& how) {
                             return std::make_unique<AskedEngine>(world, name, how.substeps, how.sweeps, how.dt());
                           },
                       .sweeps = the_adapter().sweeps(name)});
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
