/// An adapter to begin with, in C++. It has no engine: bodies fly, turn and fall, and touch nothing. Put yours where "engine" stands.
/// docs/benchmark.md says what is asked. Compile it by itself:
///
///   g++ -std=c++20 -O3 -ffp-contract=off template.cpp -o my_engine      (with the Debian package nlohmann-json3-dev)
///   ./course run adapter my_engine sliding template/16                      a motion in 16 substeps: how far from the truth
#include <chrono>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace {

using Json = nlohmann::json;
using Numbers = std::vector<double>;

/// engine: a body of it. What the scene gives besides (mass, inertia, shape, friction, restitution, joints) a real one needs.
struct Body {
  bool moves;
  Numbers position, orientation, velocity, angular_velocity;
};

/// engine: a world of it.
struct World {
  Numbers gravity;
  std::vector<Body> bodies;

  void step(double h) {
    for (Body& body : bodies) {
      if (!body.moves) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        body.velocity[i] += h * gravity[i];
        body.position[i] += h * body.velocity[i];
      }
    }
  }
};

void put(Body& body, const Json& from) {
  body.position = from["position"].get<Numbers>();
  body.orientation = from["orientation"].get<Numbers>();  // w, x, y, z
  body.velocity = from["velocity"].get<Numbers>();
  body.angular_velocity = from["angular_velocity"].get<Numbers>();
}

World world_of(const Json& scene) {
  World world{scene["gravity"].get<Numbers>(), {}};
  for (const Json& from : scene["bodies"]) {
    Body& body = world.bodies.emplace_back();
    body.moves = !from["mass"].is_null();
    put(body, from);
  }
  return world;
}

/// 13 numbers a body; of those that nothing moves, null.
Json states_of(const World& world) {
  Json states = Json::array();
  for (const Body& body : world.bodies) {
    if (!body.moves) {
      states.push_back(nullptr);
      continue;
    }
    Json& state = states.emplace_back(Json::array());
    for (const Numbers* numbers : {&body.position, &body.orientation, &body.velocity, &body.angular_velocity})
      for (const double number : *numbers) state.push_back(number);
  }
  return states;
}

World world;  // that is open

Json answer(const Json& asked) {
  const std::string what = asked["ask"];
  if (what == "settings")
    return {{"engine", "Template 1"},
            {"settings", {{{"name", "template"}, {"what", "as it comes: bodies fly"}, {"sweeps", false}}}}};
  if (what == "open") {
    if (!asked["scene"]["joints"].empty()) return {{"plays", false}, {"lacks", "joints"}};
    world = world_of(asked["scene"]);
    return {{"plays", true}};
  }
  // step: first what others have changed, then so many steps, timed; then where all bodies are
  for (const Json& from : asked.value("put", Json::array())) put(world.bodies.at(from["body"]), from);
  const auto begin = std::chrono::steady_clock::now();
  for (int i = 0; i < asked["steps"]; ++i) world.step(asked["h"]);
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  return {{"seconds", took.count()}, {"states", states_of(world)}};
}

}  // namespace

int main() {
  for (std::string line; std::getline(std::cin, line);) std::cout << answer(Json::parse(line)) << '\n' << std::flush;
}
