#include "pushback/tools/measure/outside/scene.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/named.h"
#include "pushback/common/world/measure.h"
#include "pushback/tools/measure/adapters/scene_json.h"
#include "pushback/tools/measure/hard_cases/standing.h"

namespace pushback::outside {

namespace {

Look largest(std::function<Real(const World&)> of, Real after) {
  return [of = std::move(of), after, most = Real(0)](const World& now) mutable {
    if (now.time > after) most = std::max(most, of(now));
    return most;
  };
}

/// The largest of a number of each movable body.
Look largest_of_bodies(const std::function<Real(const Body&)>& of, Real after) {
  return largest(
      [of](const World& now) {
        Real most = 0;
        for (const Body& body : now.bodies)
          if (body.movable()) most = std::max(most, of(body));
        return most;
      },
      after);
}

Look count_of_bodies(const std::function<bool(const Body&)>& condition) {
  return largest(
      [condition](const World& now) {
        return Real(std::count_if(now.bodies.begin(), now.bodies.end(),
                                  [&](const Body& body) { return body.movable() && condition(body); }));
      },
      0);
}

Real root_mean_square_speed(const World& now) {
  Real sum = 0, count = 0;
  for (const Body& body : now.bodies) {
    if (!body.movable()) continue;
    sum += body.velocity.squaredNorm();
    ++count;
  }
  return std::sqrt(sum / count);
}

Real largest_gap(const World& now) {
  Real most = 0;
  for (const Joint& joint : now.joints) most = std::max(most, gap_of(now, joint));
  return most;
}

/// Degrees from straight below the origin: where the middle of the bodies is.
Real angle_from_below(const World& now) {
  Vec3 sum = Vec3::Zero();
  for (const Body& body : now.bodies)
    if (body.movable()) sum += body.position;
  return std::abs(std::atan2(sum.x(), -sum.y())) * 180 / pi;
}

/// mm/s: how far the pushed bodies' velocities are from what they must be.
Look error_of_speed(const OutsideScene& scene) {
  return largest(
      [pushes = scene.pushes](const World& now) {
        Real most = 0;
        for (const Push& push : pushes)
          most = std::max(most, 1000 * (now.body(push.body).velocity - now.time * push.acceleration).norm());
        return most;
      },
      0);
}

/// % to either side. A body that moves by v += h g, x += h v has up to m g h v / 2 more or less, 1.7 % for whole steps.
Look error_of_energy(const World& start) {
  const Real before = kinetic_energy(start) + potential_energy(start);
  return largest(
      [before](const World& now) {
        return 100 * std::abs(kinetic_energy(now) + potential_energy(now) - before) / before;
      },
      0);
}

/// mm: the sphere, body 1, along a finger, body 2.
Look slip(Real after) {
  return [after, begun = Real(0), most = Real(0)](const World& now) mutable {
    const Real over = now.bodies[1].position.y() - now.bodies[2].position.y();
    if (now.time < after) begun = over;
    return most = std::max(most, 1000 * std::abs(over - begun));
  };
}

/// % of g sin 45: the error of what bodies 1 to 11, boxes, and 12 to 22, balls, gain in speed in the third second. Boxes slide, balls
/// roll unless they have no friction. Their friction is 0 to 1, that of a pair its root.
Look slides_and_rolls() {
  return [speeds = std::vector<Real>(23, 0)](const World& now) mutable {
    const Real g = std::sqrt(Real(0.5)) * Real(9.81), since = now.time - 2;
    Real error = 0;
    for (std::size_t i = 1; i < 23; ++i) {
      if (since < Real(1e-6)) speeds[i] = now.bodies[i].velocity.norm();
      const Real mu = std::sqrt(Real(0.1) * Real((i - 1) % 11));
      const Real due = i < 12 ? 1 - mu : mu > 0 ? Real(5) / 7 : 1;
      error = std::max(error, 100 * std::abs((now.bodies[i].velocity.norm() - speeds[i]) / g - due));
    }
    return error;
  };
}

/// % of the 18 m: the error of the height of the first bounce, e^2. Bodies 1 to 11 and 12 to 22 have e = 0 to 1.
Look bounces() {
  return [apex = std::vector<Real>(23, 0)](const World& now) mutable {
    Real error = 0;
    for (std::size_t i = 1; i < 23; ++i) {
      if (now.time > 2) apex[i] = std::max(apex[i], now.bodies[i].position.y() - 2);
      const Real e = Real(0.1) * Real((i - 1) % 11);
      error = std::max(error, 100 * std::abs(apex[i] / 18 - e * e));
    }
    return error;
  };
}

/// mm
Look displacement(const World& start) {
  return largest_of_bodies(
      [start](const Body& body) {
        const Vec3 moved = body.position - start.bodies[static_cast<std::size_t>(body.index)].position;
        return 1000 * std::hypot(moved.x(), moved.z());
      },
      0);
}

using Judge = std::function<Look(const OutsideScene&, const World& start)>;
const std::map<std::string, Judge>& judges() {
  using S = const OutsideScene&;
  using W = const World&;
  static const std::map<std::string, Judge> all{
      {"accelerates", [](S scene, W) { return error_of_speed(scene); }},
      {"bounces", [](S, W) { return bounces(); }},
      {"climbs", [](S scene, W) { return largest(angle_from_below, scene.after); }},
      {"comes down",  // the last body, m
       [](S, W start) {
         return largest([y = start.bodies.back().position.y()](W now) { return y - now.bodies.back().position.y(); },
                        0);
       }},
      {"energy", [](S, W start) { return error_of_energy(start); }},
      {"gapes", [](S, W) { return largest([](W now) { return 1000 * largest_gap(now); }, 0); }},
      {"is displaced", [](S, W start) { return displacement(start); }},
      {"leaves the drum",
       [](S, W) {
         return count_of_bodies([](const Body& body) {
           return std::hypot(body.position.x(), body.position.y()) > 16.5 && std::abs(body.position.z()) < 10;
         });
       }},
      {"moves", [](S scene, W) { return largest([](W now) { return 1000 * largest_speed(now); }, scene.after); }},
      {"moves on the whole",
       [](S scene, W) { return largest([](W now) { return 1000 * root_mean_square_speed(now); }, scene.after); }},
      {"overlaps", [](S scene, W) { return largest([](W now) { return 1000 * deepest_overlap(now); }, scene.after); }},
      {"rises", [](S, W) { return largest_of_bodies([](const Body& body) { return body.velocity.y(); }, 0); }},
      {"sinks", [](S, W) { return count_of_bodies([](const Body& body) { return body.position.y() < 0; }); }},
      {"slides and rolls", [](S, W) { return slides_and_rolls(); }},
      {"slips", [](S scene, W) { return slip(scene.after); }}};
  return all;
}

}  // namespace

const std::vector<OutsideScene>& outside_scenes() {
  static const std::vector<OutsideScene> all = [] {
    std::vector<OutsideScene> list;
    for (const Json& json : Json::parse(scene_text("scenes"))) {
      OutsideScene scene{json["name"],  json["title"],          json["source"], json["judge"],
                         json["must"],  json["unit"],           json["limit"],  json["seconds"],
                         json["after"], json["half_thickness"], json["gain"],   {}};
      for (const Json& push : json.value("pushes", Json::array()))
        scene.pushes.push_back(
            {push["body"], vec3_of(push["force"]), vec3_of(push.value("acceleration", Json{0, 0, 0}))});
      list.push_back(scene);
    }
    return list;
  }();
  return all;
}

const OutsideScene& scene_named(const std::string& name) {
  return named("scene", outside_scenes(), name);
}

World begin(const OutsideScene& scene) {
  World world;
  if (const LargeScene* large = large_scene(scene.name)) large->fill(world);
  else world = scene_of(Json::parse(scene_text(scene.name)));
  for (const Push& push : scene.pushes)
    world.forces.push_back({[push](World& now) { now.body(push.body).force += push.force; }, "a push", {push.body}});
  return world;
}

Look look_at(const OutsideScene& scene, const World& start) {
  return judges().at(scene.judge)(scene, start);
}

std::string scene_text(const std::string& name) {
  return read_text_file(std::string(OUTSIDE_SCENES) + "/" + name + ".json");
}

}  // namespace pushback::outside
