// Chapters 07 and 20: what contact points are called, and who feels whom.
#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "pushback/chapters/07_warm_start/full_solver.h"
#include "pushback/chapters/20_only_what_is_needed/scenes.h"
#include "pushback/chapters/20_only_what_is_needed/sleep.h"
#include "pushback/common/collision/collide_outline.h"
#include "pushback/common/world/step.h"
#include "pushback/tools/figures/figures.h"
#include "pushback/tools/figures/svg.h"

namespace pushback::figures {

namespace {

// ---- chapter 07 ------------------------------------------------------------------------------------------------------

/// From above: x to the right, z towards the reader.
struct FromAbove {
  Place origin;
  double scale;  // px/m
  Place operator()(const Vec3& at) const { return origin + scale * Place(double(at.x()), double(at.z())); }
};

std::vector<Place> outline_of(const Body& body, const FromAbove& view) {
  const Vec3& half = std::get<Box>(body.shape).half_extents;
  std::vector<Place> corners;
  for (const auto& [x, z] : {std::pair<Real, Real>{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
    corners.push_back(view(body.position + body.orientation * Vec3(x * half.x(), -half.y(), z * half.z())));
  return corners;
}

/// In one line or two.
std::vector<std::string> name_of(const ContactId& id) {
  const std::uint32_t number = id.feature & 0xffffu;
  if (id.feature == corner_of_b(int(number))) return {fmt::format("corner {} of $B$", number)};
  if (id.feature == corner_of_a(int(number))) return {fmt::format("corner {} of $A$", number)};
  return {fmt::format("edge {} of $A$,", number >> 8), fmt::format("edge {} of $B$", number & 0xffu)};
}

const Contact* with_id(const Contacts& contacts, const ContactId& id) {
  const auto found = std::find_if(contacts.begin(), contacts.end(), [&](const Contact& c) { return c.id == id; });
  return found == contacts.end() ? nullptr : &*found;
}

struct Instant {
  World world;
  int step = 0;
};

/// A box slides over the edge of a table, turning a little: the step in which its contact points get other names, and that
/// before it. Of a step, bodies are where its contacts were found.
std::pair<Instant, Instant> two_steps() {
  World world;
  world.add(box({1, Real(0.2), Real(0.75)}, 1).fixed().at({0, Real(-0.2), 0}).rough(Real(0.3)));
  world.add(box({Real(0.4), Real(0.25), Real(0.3)}, 10)
                .turned(Real(0.14), Vec3::UnitY())
                .at({-Real(0.4), Real(0.2499), Real(0.02)})
                .moving({5, 0, 0})
                .rough(Real(0.3)));
  FullSolver solver;
  Instant before;
  for (int step = 1; step < 60; ++step) {
    Instant now{world, step};
    world.step(solver, Real(1) / 60, 20);
    now.world.contacts = world.contacts;
    const bool another =
        step > 1 && std::any_of(now.world.contacts.begin(), now.world.contacts.end(), [&](const Contact& contact) {
          return with_id(before.world.contacts, contact.id) == nullptr;
        });
    if (another) return {before, now};
    before = now;
  }
  return {before, before};
}

/// Name and impulse, above or below the point, and not over the table's edge to its right.
void label(Svg& svg, const Place& at, bool above, bool right, const std::vector<std::string>& lines) {
  double y = at.y() + (above ? -18 - 19 * static_cast<double>(lines.size() - 1) : 34);
  for (const std::string& line : lines) {
    svg.text({at.x() - (right ? 2 : 0), y}, line,
             {right ? at_right : at_middle, 15, &line == &lines.back() ? hue::grey : hue::ink});
    y += 19;
  }
}

}  // namespace

std::string ids_from_step_to_step() {
  const auto [before, now] = two_steps();
  Svg svg(830, 430, "The contact points of a box that slides over the edge of another, in two consecutive steps");
  double x = 24;
  for (const Instant* instant : {&before, &now}) {
    const FromAbove view{{x + 85, 205}, 210};
    const Body &a = instant->world.bodies[0], &b = instant->world.bodies[1];
    std::vector<Place> table = outline_of(a, view);
    table[0].x() = table[3].x() = x;  // its left part is cut off
    svg.polygon(table, hue::pale_blue, {hue::none, 0});
    svg.polyline(table, {hue::blue, 2.5});
    if (instant == &now) svg.polygon(outline_of(before.world.bodies[1], view), hue::none, {hue::pale_grey, 2, true});
    svg.polygon(outline_of(b, view), hue::none, {hue::vermilion, 2.5});
    for (const Contact& contact : instant->world.contacts) {
      const Contact* known = instant == &before ? &contact : with_id(before.world.contacts, contact.id);
      const Place at = view(contact.point);
      std::vector<std::string> lines = name_of(contact.id);
      const Real impulse = known == nullptr ? 0 : known->impulse.dot(known->normal);
      lines.push_back(fmt::format("{:.2f} N s", impulse));
      svg.circle(at, 8, known != nullptr ? hue::yellow : hue::white, {hue::ink, 2});
      label(svg, at, contact.point.z() < b.position.z(), contact.point.x() > b.position.x(), lines);
    }
    for (const Contact& contact : before.world.contacts) {
      if (with_id(instant->world.contacts, contact.id) != nullptr) continue;
      const Place at = view(contact.point);
      svg.line(at - Place(7, 7), at + Place(7, 7), {hue::grey, 3});
      svg.line(at - Place(7, -7), at + Place(7, -7), {hue::grey, 3});
    }
    svg.text({x, 26},
             fmt::format("step {}: the impulses {}", instant->step,
                         instant == &before ? "that it ends with" : "that it starts from"),
             {.size = 16, .bold = true});
    svg.text({x + 12, 74}, "body $A$", {.size = 16, .colour = hue::blue});
    svg.text(view(b.position) + Place(0, 5), "body $B$", {at_middle, 16, hue::vermilion});
    x += 415;
  }
  svg.circle({36, 402}, 8, hue::yellow, {hue::ink, 2});
  svg.text({54, 407}, "the step before had this id, too", {.size = 15});
  svg.circle({320, 402}, 8, hue::white, {hue::ink, 2});
  svg.text({338, 407}, "a new id: it starts from 0", {.size = 15});
  svg.line({575, 395}, {589, 409}, {hue::grey, 3});
  svg.line({575, 409}, {589, 395}, {hue::grey, 3});
  svg.text({600, 407}, "an id that is gone", {.size = 15});
  return svg.str();
}

// ---- chapter 20 ------------------------------------------------------------------------------------------------------

std::string graph_and_islands() {
  World world, before;
  only_what_is_needed_scenes::FivePiles{}(world);
  FullSolver solver;
  Sleep sleep;
  const int ball = int(world.bodies.size()) - 1;
  const auto hits = [&] {
    return std::any_of(world.contacts.begin(), world.contacts.end(), [&](const Contact& contact) {
      return int(contact.id.body_b) == ball && world.bodies[contact.id.body_a].movable();
    });
  };
  for (int i = 0; i < 240 && !hits(); ++i) {
    before = world;
    step(world, solver, Real(1) / 60, 10, sleep);
  }
  before.find_contacts();  // of that step, and those of sleepers, too

  Islands islands;
  std::vector<int> movable;
  for (const Body& body : world.bodies) {
    if (body.movable()) movable.push_back(body.index);
  }
  islands.separate(movable, world.bodies.size());
  islands.join(before.contacts, before);

  Svg svg(830, 440, "Who touches whom, and the islands");
  constexpr double ground_y = 385;
  const auto at = [&](int i) {
    const Vec3& where = before.bodies[std::size_t(i)].position;
    return Place(415 + 41 * double(where.x()), 252 - 66 * (double(where.y()) - 0.5) + 58 * double(where.z()));
  };
  std::map<int, std::vector<int>> by_island;
  for (const int i : movable) by_island[islands.island_of(i)].push_back(i);
  for (const auto& [root, bodies] : by_island) {
    Place low = at(root), high = low;
    for (const int i : bodies) low = low.cwiseMin(at(i)), high = high.cwiseMax(at(i));
    low -= Place(27, 27), high += Place(27, 27);
    const bool asleep = world.bodies[std::size_t(root)].asleep;
    svg.polygon({low, {high.x(), low.y()}, high, {low.x(), high.y()}}, asleep ? hue::haze : hue::pale_amber,
                {asleep ? hue::grey : hue::amber, 1.8, true});
    svg.text({(low.x() + high.x()) / 2, low.y() - 12}, asleep ? "asleep" : "awake",
             {at_middle, 17, asleep ? hue::grey : hue::ink, true});
  }
  std::set<std::pair<int, int>> pairs;
  std::set<int> on_ground;
  for (const Contact& contact : before.contacts) {  // several points of one pair: the same line
    const int a = int(contact.id.body_a), b = int(contact.id.body_b);
    if (before.bodies[std::size_t(a)].movable()) pairs.emplace(a, b);
    else on_ground.insert(b);
  }
  for (const auto& [a, b] : pairs) svg.line(at(a), at(b), {hue::ink, 2.5});
  for (const int b : on_ground) svg.line(at(b), {at(b).x(), ground_y}, {hue::grey, 2, true});
  for (const int i : movable) {
    const Body& body = world.bodies[std::size_t(i)];
    svg.circle(at(i), i == ball ? 20 : 13, body.asleep ? hue::pale_grey : hue::amber, {hue::ink, 2});
  }
  svg.text({415, 30}, "a circle is a body, a line is a pair that touches", {at_middle, 16});
  svg.text(at(ball) + Place(0, 5), "ball", {at_middle, 15});
  svg.polygon({{20, ground_y}, {810, ground_y}, {810, ground_y + 34}, {20, ground_y + 34}}, hue::haze, {hue::grey, 2});
  svg.text({415, ground_y + 23}, "ground: nothing moves it, so it joins nothing", {at_middle, 16, hue::grey});
  return svg.str();
}

}  // namespace pushback::figures
