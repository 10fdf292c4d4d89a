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
       {"Go over world.contacts once. world.bodies_of(c) returns A and B, c.normal points from A to B, and c.point is "
        "the contact point.",
        "The speed v_n along the normal is the velocity of B's point minus the velocity of A's point, along n. A point "
        "moves at v + w × r, with r = c.point − position. If v_n ≥ 0, the bodies separate and need no impulse.",
        "K = 1/m_A + 1/m_B + (r_A × n)·I_A⁻¹(r_A × n) + (r_B × n)·I_B⁻¹(r_B × n), and λ = −(1 + e) v_n / K. B gets +λ "
        "n, and A gets −λ n. Add λ n to c.impulse, then move both apart by depth, each in proportion to its 1/m."}},
      {1,
       "a row for each contact, solved again and again",
       {"Remove the bounce and the direct movement of bodies. First make a list of rows, one per contact. A row stores "
        "the data for J and K, and a sum that starts at 0.",
        "In each of `sweeps` sweeps, go over all rows. Compute λ = −J V / K with the current J V, add λ to the row's "
        "sum, and apply it to the bodies. λ may have either sign, because a row is an equation.",
        "After the sweeps, c.impulse is the sum times n. Clear the list at the start of the next call."}},
      {2,
       "contacts push and never pull",
       {"The sum of λ is never negative. This is not a bound on each λ.",
        "new sum = max(0, sum + λ). The bodies get new sum − sum."}},
      {3,
       "overlap, pushed out by a velocity",
       {"Each row gets a b, computed before the sweeps. The row then solves J V + b = 0.",
        "b = β/h C, with C = min(0, −depth), β = 0.2 and h = dt. λ = −(J V + b) / K."}},
      {4, "a little overlap is left", {"C = min(0, −depth + slop), with slop = 0.005 m. Nothing else changes."}},
      {5,
       "bounce",
       {"Compute v_n of the points before this step, with velocity_before and angular_velocity_before of both bodies.",
        "If v_n < −0.1 m/s, b = min(b, e v_n) with e = c.restitution."}},
      {6,
       "friction: two rows along the surface",
       {"tangents_of(c.normal) returns two directions. Each gets a row like the normal, with b = 0. Contacts with "
        "c.friction == 0 need none.",
        "In each sweep, solve all normals first, then all tangents. The sum of a tangent stays within ± μ times the "
        "sum of its contact's normal.",
        "Store the contact's index in each row, because a tangent's position in its list differs from its normal's "
        "position. c.impulse is the sum of all three."}},
      {7,
       "the impulses of the previous step as the initial guess",
       {"world.contacts_before contains the contacts of the previous step with their impulses. Both lists are sorted "
        "by id.",
        "Before the sweeps, each row starts with world.impulse_scale(dt) times the old impulse of the same id, "
        "projected on its direction: · n for the normal, · t for each tangent.",
        "To start with an impulse means two things: it is the row's sum, and the bodies receive it. The normal's part "
        "is never negative."}},
      {8,
       "a disc instead of the square",
       {"Solve both tangents of a contact together. Read both slips and compute both new sums. If the length of (sum₁, "
        "sum₂) exceeds μ times the normal's sum, scale both back to this bound. Then apply them.",
        "Both use the same step size 1/k, where k is the larger eigenvalue of the 2 × 2 matrix (k₁₁ k₁₂; k₁₂ k₂₂) of "
        "the two tangents. k₁₂ is the speed along t₂ that an impulse of 1 N s along t₁ causes.",
        "k = (k₁₁ + k₂₂)/2 + hypot((k₁₁ − k₂₂)/2, k₁₂)."}},
      {9,
       "bounces as if from the surface, solved until nothing changes",
       {"Start from the solver of chapter 08. If a row has u = −v_n⁻ > 0.1 m/s and e > 0, its bounce is no longer e u. "
        "Read h a = max(0, v_n⁻ − J V) before any impulse. It is the approach speed that this step's forces have "
        "added.",
        "S = u²/2 − a d + h a u/2, with the depth d. If S > 0, b = h a/2 − √((h a/2)² + 2 (e² S + a d)), whatever the "
        "push-out is. Otherwise keep the push-out.",
        "In each sweep, after the normals and before friction, check whether a contact bounces. If so, solve all "
        "normals repeatedly until no J V changes by more than a millionth of the fastest bounce, but at most a "
        "thousand times."}},
      {10,
       "overlap, removed without a speed",
       {"Start from the solver of chapter 08. b is only the bounce, or 0. Each row stores C = min(0, −depth + slop).",
        "after_move(world, dt) is called after the bodies have moved. b' = max(0.2 min(0, C + h J V), −0.05 m)/h if C "
        "< 0, and 0 otherwise. Save all velocities and set them to 0, set all sums to 0, and sweep the normals ten "
        "times with b'.",
        "Then x += h v' and q += h/2 (0, w') q, normalised, with refresh_inertia(). Restore the saved velocities."}},
      {11,
       "32 substeps of one sweep",
       {"Start from the solver of chapter 08. Nothing in `solve` changes. A step calls it more often, each time with "
        "the dt of a substep.",
        "Override Plan plan(Real dt) const. It returns .detections = 32, so that contacts are detected in every "
        "substep, and .sweeps = 1."}},
      {12,
       "contacts as springs with dampers",
       {"Once per substep, compute ω = 2π min(240, 1/(8h)), the push-out rate k/(c + hk) = ω/(2ζ + hω), and γ/K = "
        "1/(hω(2ζ + hω)), with ζ = 5.",
        "A normal with depth > 0 that does not bounce gets b = −rate · depth, γ = γ/K · K and 1/(K + γ). If b would be "
        "below −3 m/s, use b = −3 m/s and no γ. A row solves J V + b + γ Σλ = 0.",
        "In after_move(world, dt), update every row, including tangents, to the new positions of the bodies: arms, M⁻¹ "
        "Jᵀ, K, and the step sizes of the tangents. Set b to only the bounce and γ to 0, sweep once more, and store "
        "the impulses again."}},
      {13,
       "joints, whose rows can also pull",
       {"supports_joints() returns true. For each joint of world.joints, call joint.ask(a, b, {world.time, dt}, "
        "equations) with world.body(joint.a) and world.body(joint.b). world.body also accepts the_world.",
        "Add a row for each equation with its Jacobian, b = bias + 0.2/dt · error, γ = softness, 1/(K + γ), and limits "
        "dt · lo and dt · hi. If n is 0, K has no 1/m. Solve these rows after the normals in each sweep.",
        "In after_move, evaluate the equations again. A row without softness gets the new Jacobian and b = bias. A row "
        "with softness stays as it is."}},
      {14,
       "joints that remember their load",
       {"Resize joint.last_impulses to the number of the joint's equations. Before the sweeps, each row starts with "
        "world.impulse_scale(dt) times its stored number, and the bodies receive it.",
        "If softness is 0, keep 0.2/dt · error apart. Sweep without it, with 20 passes over the joints in each sweep, "
        "and write the sums into joint.last_impulses. Then add it to b, and solve the joints sweeps · 20 times more.",
        "In after_move, first change each sum back to joint.last_impulses, and apply the difference to the bodies. "
        "After the last sweep, store the sums there again."}},
      {21,
       "contacts detected once per step, and tracked through 32 substeps",
       {"Start from the solver of chapter 12. The plan is .substeps = 32, .sweeps = 1, .margin = {0.02, dt}. Make the "
        "rows and the initial guess in after_detection(world, h), once per step. Set b of the bounce there too: e J V "
        "if J V < −0.1 m/s. solve starts each row with the impulse it already has, and applies it to the bodies.",
        "The guess must be within the friction cone of the new normal: pushed = max(0, impulse · n), and its "
        "tangential part is at most μ pushed.",
        "C starts at −depth. In after_move, add h J V to C before you update the rows. In solve, use a rigid row with "
        "b = C/h if C > 0. If C ≤ 0, use chapter 12's spring with the depth −C. The relaxing sweep has b = max(b, 0).",
        "In end_detection, set c.depth = −C and c.last_impulse to the impulse of the last substep. If a contact with a "
        "bounce has given any impulse in the step, set all impulses to 0 and b to the bounce, and sweep ten times. "
        "c.impulse is the sum over the substeps and the bounce. Erase contacts with depth < 0 and no impulse."}},
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

const ChapterOfMine& chapter_of_mine(std::string_view word) {
  std::vector<std::string> names;
  for (const ChapterOfMine& chapter : chapters_of_mine()) {
    const std::string number = two_digits(chapter.number), folder = folder_of(chapter.number);
    if (word == number || number == "0" + std::string(word) || word == folder || word == folder.substr(3))
      return chapter;
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
