/// Checks the headers of these three pages, yours or ours, as far as there are any in the folder behind -I:
///
///     g++ -std=c++20 -O1 -isystem /usr/include/eigen3 -I mine docs/from_an_empty_file/check.cpp -o mine/check && mine/check
#include <body.h>
#if __has_include(<touch.h>)
#include <touch.h>
#endif
#if __has_include(<names.h>)
#include <names.h>
#endif

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <set>

using namespace empty_file;

namespace {

int wrong = 0;

void check(const char* what, double is, double right, double tolerance = 1e-9) {
  const bool passed = std::abs(is - right) <= tolerance * std::max(1., std::abs(right));
  std::printf(passed ? "  ok     %s\n" : "  wrong  %s: %.6g, where %.6g is right\n", what, is, right);
  wrong += !passed;
}

std::mt19937 generator(1);
double between(double lo, double hi) {
  return std::uniform_real_distribution<double>(lo, hi)(generator);
}
Vec3 within(double size) {
  return {between(-size, size), between(-size, size), between(-size, size)};
}
Mat3 axes(const Body& body) {
  return body.orientation.toRotationMatrix();
}
Body turned_box(const Vec3& half, double mass) {
  Body made = box(half, mass);
  made.position = within(2);
  made.orientation = Eigen::AngleAxisd(between(0.5, 2), within(1).normalized());
  return made;
}
Vec3 angular_momentum(const Body& body) {
  return axes(body) * (axes(body).transpose() * body.angular_velocity).cwiseQuotient(body.inverse_inertia);
}

void check_bodies() {
  std::puts("1: a body and its step");
  const Vec3 half(0.4, 0.3, 0.7), impulse(1, 2, 3), arm(0.1, -0.3, 0.2), gravity(0, -9.81, 0);
  Body body = turned_box(half, 5), fixed = body;
  check("its inverse mass, 1/kg", body.inverse_mass, 1. / 5);
  check("its inverse inertia about its first axis, 1/(kg m^2)", body.inverse_inertia.x(), 3 / (5 * (0.09 + 0.49)));
  check("its inverse inertia about its third axis, 1/(kg m^2)", body.inverse_inertia.z(), 3 / (5 * (0.16 + 0.09)));
  push(body, impulse, body.position + arm);
  const Vec3 spin = axes(body) * (axes(body).transpose() * arm.cross(impulse)).cwiseProduct(body.inverse_inertia);
  check("an impulse changes the velocity: off by, m/s", (body.velocity - impulse / 5).norm(), 0);
  check("an impulse beside the centre changes the spin: off by, rad/s", (body.angular_velocity - spin).norm(), 0);

  body = box(half, 5);
  fixed = body;
  fixed.inverse_mass = 0;
  fixed.inverse_inertia.setZero();
  for (int step = 0; step < 20; ++step)
    for (Body* each : {&body, &fixed}) accelerate(*each, gravity, 0.01), move(*each, 0.01);
  check("it falls, first the velocity, then the place, to, m", body.position.y(), -9.81 * 1e-4 * 20 * 21 / 2);
  check("a body that nothing moves has fallen, m", (fixed.position - box(half, 5).position).norm(), 0);

  body = turned_box({0.9, 0.15, 0.45}, 5);
  body.angular_velocity = axes(body) * Vec3(1, 1, 5);
  const Vec3 before = angular_momentum(body);
  const double energy = body.angular_velocity.dot(before) / 2;
  for (int step = 0; step < 100; ++step) move(body, 0.01);
  check("the length of its quaternion", body.orientation.norm(), 1);
  check("free, its angular momentum changes by, kg m^2/s", (angular_momentum(body) - before).norm(), 0, 1e-6);
  check("its energy over that of the start", body.angular_velocity.dot(angular_momentum(body)) / 2 / energy, 1, 5e-3);
}

#if __has_include(<touch.h>)
/// One point, `depth` deep, midway between the surfaces.
void check_one(const char* what, const Touches& found, const Vec3& normal, const Vec3& point, double depth) {
  std::printf("  %s\n", what);
  check("  points", static_cast<double>(found.size()), 1);
  if (found.empty()) return;
  check("  depth, m", found[0].depth, depth);
  check("  its normal, from A to B, is off by", (found[0].normal - normal).norm(), 0);
  check("  its point is off by, m", (found[0].point - point).norm(), 0);
}

void check_touching() {
  std::puts("2: where two bodies touch");
  const Vec3 n = Vec3(1, 2, -1).normalized(), on_plane = 0.5 * n;
  check_one("a ball in a plane", touch(Plane{n, 0.5}, Ball{on_plane + 0.3 * n, 0.4}), n, on_plane - 0.05 * n, 0.1);
  check_one("two balls", touch(Ball{on_plane, 0.5}, Ball{on_plane + 0.8 * n, 0.4}), n, on_plane + 0.45 * n, 0.1);
  check("a ball over a plane touches at", static_cast<double>(touch(Plane{n, 0}, Ball{2 * n, 1}).size()), 0);
  check("balls that are apart touch at", static_cast<double>(touch(Ball{-n, 0.4}, Ball{n, 0.4}).size()), 0);

  const Body tilted = turned_box({0.4, 0.3, 0.7}, 5);
  double corners = 0, depths = 0, sum = 0;
  for (int i = 0; i < 8; ++i) {
    const Vec3 signs(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
    const double depth = -(axes(tilted) * tilted.half.cwiseProduct(signs)).dot(n);
    if (depth >= 0) ++corners, depths += depth;
  }
  const Touches below = touch(Plane{n, tilted.position.dot(n)}, tilted);
  for (const Touch& one : below) sum += one.depth;
  check("corners of a box below a plane", static_cast<double>(below.size()), corners);
  check("their depths together, m", sum, depths);

  Body a = box({1, 0.5, 1}, 1), b = box({0.6, 0.6, 0.6}, 1);
  b.position = {0.3, 1, 0.1};
  Axis axis, other;
  check("two boxes overlap, 1 or 0", least_overlap(a, b, axis) && least_overlap(b, a, other), 1);
  check("by, m", axis.depth, 0.1);
  check("their normal leads from A to B, 1 or -1", axis.normal.y(), 1);
  check("and with A and B exchanged", other.normal.y(), -1);
  b.position.y() = 1.2;
  check("boxes that are apart overlap, 1 or 0", least_overlap(a, b, axis = {}), 0);

  a = box({1, 0.4, 0.4}, 1);
  b = box({0.4, 0.4, 1}, 1);
  a.orientation = Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitX());
  b.orientation = Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitZ());
  const double reach = 0.4 * std::numbers::sqrt2;
  b.position = {0.2, 2 * reach - 0.05, 0.1};
  if (least_overlap(a, b, axis = {}))
    check_one("an edge across an edge", {touch_of_edges(a, b, axis)}, Vec3::UnitY(), {0.2, reach - 0.025, 0}, 0.05);
  else check("an edge across an edge overlaps, 1 or 0", 0, 1);
}
#endif

#if __has_include(<names.h>)
std::set<int> names(const Touches& touches) {
  std::set<int> all;
  for (const Touch& one : touches) all.insert(one.name);
  return all;
}
double in_both(const Touches& before, const Touches& now) {
  const std::set<int> old = names(before), all = names(now);
  return static_cast<double>(std::count_if(all.begin(), all.end(), [&](int name) { return old.contains(name); }));
}

void check_names() {
  std::puts("3: what a contact is called");
  const Body a = box({2, 0.5, 2}, 1);
  const auto touches = [&](double x, double rolled) {
    Body b = box({0.5, 0.5, 0.5}, 1);
    b.orientation = Eigen::AngleAxisd(0.15, Vec3::UnitY()) * Eigen::AngleAxisd(rolled, Vec3::UnitZ());
    b.position = {x, 0.99, 0.3};
    return touch(a, b);
  };
  const Touches whole = touches(1, 0), over = touches(2, 0);
  check("a cube on a slab touches at", static_cast<double>(whole.size()), 4);
  double beside = 0, depth = 0;
  for (const Touch& one : over) {
    beside = std::max(beside, one.point.x() - 2);
    depth = std::max(depth, one.depth);
  }
  check("over the edge it touches beside the slab by, m", beside, 0);
  check("over the edge it is deep by, m", depth, 0.01);
  check("points with a name of their own", static_cast<double>(names(over).size()), static_cast<double>(over.size()));
  check("names kept after a move of 10 um", in_both(whole, touches(1 + 1e-5, 0)), static_cast<double>(whole.size()));
  check("names kept over the edge", in_both(whole, over), 2);
  check("names kept on the cube's next face", in_both(whole, touches(1, std::numbers::pi / 2)), 0);
}
#endif

}  // namespace

int main() {
  check_bodies();
#if __has_include(<touch.h>)
  check_touching();
#endif
#if __has_include(<names.h>)
  check_names();
#endif
  std::printf(wrong == 0 ? "all is right\n" : "%d wrong\n", wrong);
  return wrong == 0 ? 0 : 1;
}
