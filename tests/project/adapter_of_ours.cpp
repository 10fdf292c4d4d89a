/// An adapter for the tests: the engine behind the pipe is ours, so that what comes out can be compared with what goes in. ADAPTER_DEFECT in the
/// environment makes it answer wrongly.
#include <chrono>
#include <cstdlib>
#include <iostream>
#include <thread>

#include "pushback/common/basics/input.h"
#include "pushback/tools/measure/adapters/scene_json.h"
#include "tests/project/jointed.h"

using namespace pushback;

namespace {

Vec3 vector_of(const Json& json) {
  return {json[0].get<Real>(), json[1].get<Real>(), json[2].get<Real>()};
}

void put(Body& body, const Json& from) {
  body.position = vector_of(from["position"]);
  const Json& q = from["orientation"];
  body.orientation = Quat(q[0], q[1], q[2], q[3]);
  body.velocity = vector_of(from["velocity"]);
  body.angular_velocity = vector_of(from["angular_velocity"]);
}

struct Opened {
  World world;
  Jointed solver;
  int sweeps = 1;
};

Json states_of(const World& world) {
  Json states = Json::array();
  for (const Body& body : world.bodies) {
    if (!body.movable()) {
      states.push_back(nullptr);
      continue;
    }
    const Quat& q = body.orientation;
    const Vec3 &x = body.position, &v = body.velocity, &w = body.angular_velocity;
    states.push_back({x.x(), x.y(), x.z(), q.w(), q.x(), q.y(), q.z(), v.x(), v.y(), v.z(), w.x(), w.y(), w.z()});
  }
  return states;
}

Opened opened;

Json answer(const Json& asked) {
  if (asked["ask"] == "settings")
    return {{"engine", "Pushback through a pipe"},
            {"settings", {{{"name", "ours"}, {"what", "jointed"}, {"sweeps", true}}}}};
  if (asked["ask"] == "open") {
    try {
      opened = {scene_of(asked["scene"]), Jointed{}, asked["sweeps"]};
    } catch (const InvalidInput& lacks) {
      return {{"plays", false}, {"lacks", lacks.what()}};
    }
    return {{"plays", true}};
  }
  for (const Json& from : asked.value("put", Json::array())) {
    Body& body = opened.world.bodies.at(from["body"]);
    put(body, from);
    body.refresh_inertia();
  }
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < asked["steps"]; ++i) {
    for (const Json& from : asked.value("push", Json::array())) {
      opened.world.bodies.at(from["body"]).force = vector_of(from["force"]);
      opened.world.bodies.at(from["body"]).torque = vector_of(from["torque"]);
    }
    opened.world.step(opened.solver, asked["h"].get<Real>(), opened.sweeps);
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  return {{"seconds", took.count()}, {"states", states_of(opened.world)}};
}

}  // namespace

int main() {
  const char* const named = std::getenv("ADAPTER_DEFECT");
  const std::string defect = named == nullptr ? "" : named;
  int asked = 0;
  for (std::string line; std::getline(std::cin, line); ++asked) {
    Json said = answer(Json::parse(line));
    const bool is_step = said.contains("states");
    if (defect == "ends" && asked == 1) return 3;
    if (defect == "hangs" && asked == 1) std::this_thread::sleep_for(std::chrono::hours(1));
    if (defect == "talks") std::cout << "hello\n";
    if (defect == "few" && is_step) said["states"].erase(0);
    if (defect == "short" && is_step) said["states"].back().erase(0);
    if (defect == "slow" && is_step) said["seconds"] = 1000;
    if (defect == "words" && is_step) said["states"].back()[0] = "far";
    if (defect == "nameless" && asked == 0) said["settings"][0].erase("name");
    std::cout << said << std::endl;
  }
}
