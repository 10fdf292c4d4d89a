#include "pushback/tools/classroom/mine/below.h"

#include <fmt/format.h>

#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/tools/classroom/attempt.h"
#include "pushback/tools/classroom/kit.h"
#include "pushback/tools/classroom/mine/below_mistakes.h"
#include "pushback/tools/classroom/mine/below_scenes.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

constexpr const char* empty_body = R"(#pragma once

#include <Eigen/Geometry>

namespace empty_file {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;
using Quat = Eigen::Quaterniond;

// Yours, from docs/from_an_empty_file/1_a_body_and_its_step.md on. Check it with: ./course mine body
struct Body {
  Vec3 half = Vec3::Constant(0.5);       // half extents, m, along its own axes
  double inverse_mass = 0;               // 1/kg; 0: nothing moves it
  Vec3 inverse_inertia = Vec3::Zero();   // 1/(kg m^2), about its own axes
  Vec3 position = Vec3::Zero();          // m
  Quat orientation = Quat::Identity();   // turns its own axes into world axes
  Vec3 velocity = Vec3::Zero();          // m/s
  Vec3 angular_velocity = Vec3::Zero();  // rad/s, world axes
};

inline Body box(const Vec3& /*half*/, double /*mass*/) {
  return {};
}
inline void push(Body& /*body*/, const Vec3& /*impulse*/, const Vec3& /*point*/) {}
inline void accelerate(Body& /*body*/, const Vec3& /*gravity*/, double /*h*/) {}
inline void move(Body& /*body*/, double /*h*/) {}

}  // namespace empty_file
)";

constexpr const char* empty_touch = R"(#pragma once

#include <vector>

#include "body.h"

namespace empty_file {

// Yours, from docs/from_an_empty_file/2_where_two_bodies_touch.md on. Check it with: ./course mine touch
struct Touch {
  Vec3 point;    // m, midway between the two surfaces
  Vec3 normal;   // unit, from A to B
  double depth;  // m, 0 or more
  int name = 0;
};
using Touches = std::vector<Touch>;

struct Ball {
  Vec3 centre;
  double radius;
};
struct Plane {
  Vec3 normal;
  double offset;  // of its points p:   p . normal = offset
};

inline Touches touch(const Plane& /*plane*/, const Ball& /*ball*/) {
  return {};
}
inline Touches touch(const Ball& /*a*/, const Ball& /*b*/) {
  return {};
}
inline Touches touch(const Plane& /*plane*/, const Body& /*box*/) {
  return {};
}

/// The direction along which two boxes overlap least.
struct Axis {
  Vec3 normal = Vec3::Zero();  // unit, from A to B
  double depth = 1e300;
  int axis_a = -1, axis_b = -1;  // of a face of A, of a face of B, or of an edge of each
};
/// False where the boxes are apart.
inline bool least_overlap(const Body& /*a*/, const Body& /*b*/, Axis& /*least*/) {
  return false;
}
inline Touch touch_of_edges(const Body& /*a*/, const Body& /*b*/, const Axis& /*axis*/) {
  return {};
}

}  // namespace empty_file
)";

constexpr const char* empty_names = R"(#pragma once

#include "touch.h"

namespace empty_file {

// Yours, from docs/from_an_empty_file/3_what_a_contact_is_called.md on. Check it with: ./course mine names
inline Touches touch(const Body& /*a*/, const Body& /*b*/) {
  return {};
}

}  // namespace empty_file
)";

/// Behind the reader's text, so that its lines keep their numbers.
std::string as_answer(const PageOfMine& page) {
  std::string answer =
      "own_bodies<empty_file::Body>([](const auto& half, double mass) { return empty_file::box(half, mass); })";
  if (page.number > 1)
    answer =
        fmt::format("own_touches<empty_file::Body, empty_file::Plane, empty_file::Ball, empty_file::Axis>({})", answer);
  if (page.number > 2) answer = fmt::format("own_names<empty_file::Body>({})", answer);
  return fmt::format(
      "\n#include \"pushback/common/exercise/own_bodies.h\"\nnamespace student {{\nusing namespace pushback;\n"
      "const OwnBodies answer = {};\n}}\n",
      answer);
}

}  // namespace

const std::vector<PageOfMine>& pages_of_mine() {
  static const std::vector<PageOfMine> all{
      {1,
       "body",
       "docs/from_an_empty_file/1_a_body_and_its_step.md",
       "a body and its step",
       {"box: with half extents a, b, c the inertia about the axis along a is m/3 (b² + c²). Keep 1/m and 1/I.",
        "push: v += P / m, ω += I⁻¹ (r × P), with r = point − position and I⁻¹ = R I_body⁻¹ Rᵀ in world axes.",
        "move: L = I ω is kept. Turn by ω for h/2, take ω of L there, turn by it for h from the start, and take ω of L "
        "again. What has an inverse mass of 0 stays."},
       empty_body},
      {2,
       "touch",
       "docs/from_an_empty_file/2_where_two_bodies_touch.md",
       "where two bodies touch",
       {"The normal points from A to B, the point lies midway between the surfaces, and a depth below 0 is no point.",
        "Boxes: of fifteen directions, three of A, three of B and nine cross products of length 1, the one in which "
        "they overlap least. One in which they do not: they are apart.",
        "Edges: the middle of the two points at which their lines come nearest. Of four parallel edges it is the one "
        "that lies farthest along the normal."},
       empty_touch},
      {3,
       "names",
       "docs/from_an_empty_file/3_what_a_contact_is_called.md",
       "what a contact is called",
       {"The face with the least overlap is the reference. Clip the other box's face at the four sides of the "
        "reference, and keep what is below it.",
        "A corner of the clipped polygon is either a corner of the face, or where an edge of the face meets a side.",
        "Which face of A, which face of B, and whose is the reference, are part of the name."},
       empty_names},
  };
  return all;
}

const PageOfMine* page_of_mine(const std::string& word) {
  for (const PageOfMine& page : pages_of_mine())
    if (page.word == word) return &page;
  return nullptr;
}

Exercise exercise_of_page(const PageOfMine& page) {
  std::vector<Check<OwnBodies>> checks;
  for (const CheckOfPage& one : checks_of_pages())
    if (one.page <= page.number) checks.push_back(one.check);
  std::vector<Mistake<OwnBodies>> mistakes;
  for (MistakeOfPage& one : mistakes_of_pages())
    if (one.page <= page.number) mistakes.push_back(std::move(one.mistake));
  Exercise made = exercise_of<OwnBodies>(page.title, page.hints, checks, bodies_of_pages(), std::move(mistakes));
  made.name = "mine_" + page.word;
  made.object = kit().folder / "libbelow_scenes.a";
  made.behind = as_answer(page);
  return made;
}

std::string header_of(const PageOfMine& page) {
  return read_text_file(kit().sources / "docs/from_an_empty_file" / page.file());
}

Attempt attempt_of_page(const Exercise& exercise, const PageOfMine& page, const fs::path& folder, std::uint64_t seed) {
  Exercise with_folder = exercise;
  with_folder.folder = folder.string();
  return attempt(with_folder, folder / page.file(), seed, nullptr);
}

}  // namespace pushback
