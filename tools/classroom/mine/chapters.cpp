#include "pushback/tools/classroom/mine/chapters.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <limits>
#include <map>

#include "pushback/chapters/00_naive_impulses/naive.h"
#include "pushback/chapters/01_velocity_constraint/flat.h"
#include "pushback/chapters/02_clamping/flat.h"
#include "pushback/chapters/03_baumgarte/flat.h"
#include "pushback/chapters/04_slop/flat.h"
#include "pushback/chapters/05_restitution/flat.h"
#include "pushback/chapters/06_friction/flat.h"
#include "pushback/chapters/07_warm_start/flat.h"
#include "pushback/chapters/08_friction_cone/flat.h"
#include "pushback/chapters/09_impacts/flat.h"
#include "pushback/chapters/10_position_correction/flat.h"
#include "pushback/chapters/11_substeps/flat.h"
#include "pushback/chapters/12_soft_contacts/flat.h"
#include "pushback/chapters/13_joints/flat.h"
#include "pushback/chapters/14_joints_under_load/flat.h"
#include "pushback/chapters/21_detected_once/flat.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/basics/input.h"
#include "pushback/tools/classroom/kit.h"
#include "pushback/tools/classroom/mine/edits.h"

namespace pushback {

namespace fs = std::filesystem;

namespace {

/// Behind the reader's text.
constexpr const char* as_answer = R"(
#include "pushback/common/exercise/whole_solver.h"
namespace mine {}
namespace student {
using namespace mine;
const pushback::WholeSolver answer = pushback::whole_solver<MySolver>();
}
)";

}  // namespace

const std::vector<ChapterOfMine>& chapters_of_mine() {
  static const std::vector<ChapterOfMine> all{
      {0,
       "an impulse for every contact",
       {"Go over world.contacts once. world.bodies_of(c) gives A and B, c.normal points from A to B, c.point is where "
        "they touch.",
        "The speed v_n along the normal is that of the point of B minus that of A: v + w × r, with r = c.point − "
        "position. If v_n ≥ 0, they leave each other: nothing to do.",
        "K = 1/m_A + 1/m_B + (r_A × n)·I_A⁻¹(r_A × n) + (r_B × n)·I_B⁻¹(r_B × n). λ = −(1 + e) v_n / K: B gets +λ n, A "
        "gets −λ n. Add λ n to c.impulse, then move both apart by depth, each in proportion to its 1/m."}},
      {1,
       "a row for each contact, solved over and over",
       {"Forget the bounce and the moving by hand. Make a list of rows first, one a contact: what J and K are made of, "
        "a sum that begins at 0.",
        "For each of `sweeps` sweeps, for each row: λ = −J V / K, with J V read then and there; add λ to the row's sum "
        "and give it to the bodies. Whichever sign it has: a row is an equation.",
        "After the sweeps, c.impulse is the sum times n. Clear the list at the next call."}},
      {2,
       "contacts push and never pull",
       {"The sum of λ, not each λ, is never less than 0.", "new sum = max(0, sum + λ). The bodies get new sum − sum."}},
      {3,
       "overlap, pushed out as a velocity",
       {"Each row gets a b, made before the sweeps: the row then solves J V + b = 0.",
        "b = β/h C, C = min(0, −depth), β = 0.2, h = dt. λ = −(J V + b) / K."}},
      {4, "a little overlap is left", {"C = min(0, −depth + slop), slop = 0.005 m. Nothing else changes."}},
      {5,
       "bounce",
       {"v_n of the points, as it was before this step: velocity_before and angular_velocity_before of both bodies.",
        "Where v_n < −0.1 m/s: b = min(b, e v_n), e = c.restitution."}},
      {6,
       "friction: two rows along the surface",
       {"tangents_of(c.normal) gives two directions. Each is a row like the normal, with b = 0. Contacts with "
        "c.friction == 0 need none.",
        "In each sweep all normals first, then all tangents. The sum of a tangent stays within ± μ times the sum of "
        "its contact's normal.",
        "A row says which contact it belongs to: the place of a tangent in its list is not that of its normal. "
        "c.impulse is the sum of all three."}},
      {7,
       "the impulses of the step before as the initial guess",
       {"world.contacts_before has the contacts of the step before, each with its impulse. Both lists ascend by id.",
        "Before the sweeps, each row begins with its part of world.impulse_scale(dt) times the old impulse of the same "
        "id: · n for the normal, · t for each tangent.",
        "Begin means two things: the row's sum is it, and the bodies get it. The normal's part is never less than 0."}},
      {8,
       "a disc for the square",
       {"Both tangents of a contact are solved together: read both slips, make both new sums, and if the length of "
        "(sum₁, sum₂) is more than μ times the normal's sum, scale both back to it. Then apply.",
        "Both take steps of the same size 1/k: k is the larger eigenvalue of the 2 × 2 matrix (k₁₁ k₁₂; k₁₂ k₂₂) of "
        "the two tangents, k₁₂ the speed along t₂ that an impulse of 1 N s along t₁ makes.",
        "k = (k₁₁ + k₂₂)/2 + hypot((k₁₁ − k₂₂)/2, k₁₂)."}},
      {9,
       "bounces as if from the surface, solved until nothing changes",
       {"Begin from the solver of chapter 08. Where a row has u = −v_n⁻ > 0.1 m/s and e > 0, its bounce is no longer e "
        "u: h a = max(0, v_n⁻ − J V), read before any impulse, is what this step's forces have added to the approach.",
        "S = u²/2 − a d + h a u/2, with the depth d. Where S > 0, b = h a/2 − √((h a/2)² + 2 (e² S + a d)), whatever "
        "the push-out asks for. Elsewhere the push-out stays.",
        "In each sweep, after the normals and before friction: if anything bounces, solve all normals again and again, "
        "until no J V changes by more than a millionth of the fastest bounce, at most a thousand times."}},
      {10,
       "overlap, undone without a speed",
       {"Begin from the solver of chapter 08. b is the bounce alone, or 0; each row keeps C = min(0, −depth + slop).",
        "after_move(world, dt) is called once the bodies have moved. b' = max(0.2 min(0, C + h J V), −0.05 m)/h where "
        "C < "
        "0, 0 elsewhere. Set all velocities aside and to 0, all sums to 0, and sweep the normals ten times with b'.",
        "Then x += h v', and q += h/2 (0, w') q, normalised, with refresh_inertia(). Put the velocities back."}},
      {11,
       "32 substeps of one sweep",
       {"Begin from the solver of chapter 08. Nothing in `solve` changes: a step calls it more often, each time with "
        "the dt of a substep.",
        "Override Plan plan(Real dt) const. It returns .detections = 32, so that contacts are detected in every "
        "substep, and .sweeps = 1."}},
      {12,
       "contacts that are springs with dampers",
       {"Once a substep: ω = 2π min(240, 1/(8h)), the push-out rate k/(c + hk) = ω/(2ζ + hω), γ/K = 1/(hω(2ζ + hω)), ζ "
        "= 5.",
        "A normal with depth > 0 that does not bounce gets b = −rate · depth, γ = γ/K · K and 1/(K + γ). Where b would "
        "be below −3 m/s: b = −3 m/s, without γ. A row solves J V + b + γ Σλ = 0.",
        "after_move(world, dt): carry every row, tangents too, to where the bodies are (their arms, M⁻¹ Jᵀ, K, the "
        "steps of "
        "the tangents); b is the bounce alone, γ = 0; one sweep more, and keep the impulses again."}},
      {13,
       "joints: rows that pull, too",
       {"supports_joints() returns true. For each joint of world.joints: joint.ask(a, b, {world.time, dt}, equations), "
        "with world.body(joint.a) and world.body(joint.b), which also knows the_world.",
        "A row for each equation: its Jacobian, b = bias + 0.2/dt · error, γ = softness, 1/(K + γ), limits dt · lo and "
        "dt · hi. Where n is 0, K has no 1/m. Solve these rows after the normals in each sweep.",
        "In moved, ask again. A row without softness gets the new Jacobian and b = bias alone; one with softness "
        "stays."}},
      {14,
       "joints that remember what they carry",
       {"joint.last_impulses: resize it to the number of the joint's equations. Before the sweeps, each row begins "
        "with "
        "world.impulse_scale(dt) times its number, and the bodies get it.",
        "Where softness is 0, keep 0.2/dt · error apart. Sweep without it, each time 20 passes over the joints; write "
        "the sums into joint.last_impulses; then add it to b, and solve the joints sweeps · 20 times more.",
        "In moved, first bring each sum back to joint.last_impulses, bodies included; after the last sweep, write the "
        "sums "
        "there again."}},
      {21,
       "contacts detected once, and followed through 32 substeps",
       {"Begin from the solver of chapter 12. Plan: .substeps = 32, .sweeps = 1, .margin = {0.02, dt}. Make the rows "
        "and "
        "the initial guess in after_detection(world, h), once per step; there also b of the bounce, e J V if J V < "
        "−0.1 m/s. "
        "solve starts each row from the impulse that it has, and applies it to the bodies.",
        "The guess, within the friction cone of the new normal: pushed = max(0, impulse · n), and the part along the "
        "surface is at most μ pushed.",
        "C is −depth at first. In moved, before you carry the rows: C += h J V. In solve, C > 0: b = C/h, rigid. C ≤ "
        "0: "
        "chapter 12's spring with −C for the depth. The relaxing sweep has b = max(b, 0).",
        "In done: c.depth = −C, c.last_impulse the impulse of the last substep. If a contact with a bounce has given "
        "any impulse in the step: set all impulses to 0, b to the bounce, and sweep ten times. c.impulse is the sum "
        "over "
        "the substeps and the bounce. Erase contacts with depth < 0 and no impulse."}},
  };
  return all;
}

std::string two_digits(int chapter) {
  return fmt::format("{:02}", chapter);
}

std::string folder_of(int chapter) {
  for (const auto& entry : fs::directory_iterator(kit().sources / "chapters"))
    if (entry.path().filename().string().starts_with(two_digits(chapter) + "_"))
      return entry.path().filename().string();
  throw InvalidInput(fmt::format("there is no chapter {} in {}", chapter, (kit().sources / "chapters").string()));
}

const ChapterOfMine& chapter_of_mine(const std::string& word) {
  std::vector<std::string> names;
  for (const ChapterOfMine& chapter : chapters_of_mine()) {
    const std::string number = two_digits(chapter.number), folder = folder_of(chapter.number);
    if (word == number || "0" + word == number || word == folder || word == folder.substr(3)) return chapter;
    names.push_back(number);
  }
  throw InvalidInput(fmt::format("unknown chapter '{}': one of these is needed: {}", word, fmt::join(names, ", ")));
}

int chapter_of_check(std::size_t check) {
  return checks_of_chapters()[check].chapter;
}
bool grows_from(int chapter, int earlier) {
  while (chapter > earlier) chapter = predecessor(chapter);
  return chapter == earlier;
}
bool holds(std::size_t check, int chapter) {
  const CheckOfChapter& its = checks_of_chapters()[check];
  const auto ends = [&](int one) { return one > its.chapter && grows_from(chapter, one); };
  return grows_from(chapter, its.chapter) && std::none_of(its.ends.begin(), its.ends.end(), ends);
}

Exercise exercise_of_chapter(int chapter) {
  const ChapterOfMine& told = chapter_of_mine(two_digits(chapter));
  Exercise made;
  made.title = told.title;
  made.hints = told.hints;
  made.right = [loop = plain_solver(chapter)](std::size_t check, Random& random) { return play(check, random, loop); };
  for (std::size_t i = 0; i < checks_of_chapters().size() && chapter_of_check(i) <= chapter; ++i) {
    const CheckOfChapter& its = checks_of_chapters()[i];
    Exercise::Line line;
    line.says = its.says;
    line.points = holds(i, chapter) ? 1 : 0;
    line.quantities = its.scene.quantities;
    line.stage = its.chapter;
    if (!holds(i, chapter))
      for (Quantity& quantity : line.quantities) quantity.tolerance = std::numeric_limits<double>::infinity();
    made.checks.push_back(line);
  }
  made.name = "mine_" + two_digits(chapter);
  made.behind = as_answer;
  made.object = kit().folder / "libwhole_solver_scenes.a";
  return made;
}

const WholeSolver& plain_solver(int chapter) {
  static const std::map<int, WholeSolver> loops{{0, whole_solver<NaiveOnce>()},
                                                {1, whole_solver<flat_01::FlatSolver>()},
                                                {2, whole_solver<flat_02::FlatSolver>()},
                                                {3, whole_solver<flat_03::FlatSolver>()},
                                                {4, whole_solver<flat_04::FlatSolver>()},
                                                {5, whole_solver<flat_05::FlatSolver>()},
                                                {6, whole_solver<flat_06::FlatSolver>()},
                                                {7, whole_solver<flat_07::FlatSolver>()},
                                                {8, whole_solver<flat_08::FlatSolver>()},
                                                {9, whole_solver<flat_09::FlatSolver>()},
                                                {10, whole_solver<flat_10::FlatSolver>()},
                                                {11, whole_solver<flat_11::FlatSolver>()},
                                                {12, whole_solver<flat_12::FlatSolver>()},
                                                {13, whole_solver<flat_13::FlatSolver>()},
                                                {14, whole_solver<flat_14::FlatSolver>()},
                                                {21, whole_solver<flat_21::FlatSolver>()}};
  return loops.at(chapter);
}

std::string plain_loop(int chapter) {
  const fs::path folder = kit().sources / "chapters" / folder_of(chapter);
  const bool naive = !fs::exists(folder / "flat.h");
  const std::string loop = naive ? read_text_file(folder / "naive.h")
                                 : read_text_file(folder / "flat.h") + read_text_file(folder / "flat.cpp");
  return renamed(loop, "namespace mine {\n\nusing namespace pushback;", "}  // namespace mine", "MySolver");
}

}  // namespace pushback
