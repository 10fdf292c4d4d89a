#include "pushback/engine/half_step/held_contacts.h"

#include <algorithm>
#include <cmath>

#include "pushback/common/basics/input.h"
#include "pushback/common/world/measure.h"
#include "pushback/engine/direct/contact_problem.h"

namespace pushback {

namespace {

constexpr bool in_doubles = std::numeric_limits<Real>::digits > 24;
constexpr Real level = in_doubles ? Real(1e-12) : Real(1e-6);  // m: a gap that is rounding of places, and stays
constexpr Real creeps = in_doubles ? Real(1e-9) : Real(1e-4);  // m/s: what is slower than that sticks
constexpr Real solved = in_doubles ? Real(1e-6) : Real(1e-3);  // m/s

/// Along the normal and both tangents.
Vec3 components(const Vec3& impulse, const Vec3& normal) {
  const auto [tangent1, tangent2] = tangents_of(normal);
  return {impulse.dot(normal), impulse.dot(tangent1), impulse.dot(tangent2)};
}

/// N s, for each N s along the normal of a contact that slides this way.
Vec3 pushes(const Contact& contact, const Vec3& slides) {
  return contact.normal - contact.friction * slides;
}

/// m/s, world axes, `arm` from the body's centre: the mean speed there in a drift of h, less that as it begins. A ball whose moments of
/// inertia differ changes w as it flies, and its arm stays.
Vec3 gained_in_drift(const Body& body, const Vec3& arm, Real h) {
  const Vec3 &w = body.angular_velocity, &inverse = body.principal_inverse_inertia;
  const bool ball = std::holds_alternative<Sphere>(body.shape);
  if (!ball || inverse.maxCoeff() == inverse.minCoeff() || w.isZero(0)) return Vec3::Zero();
  return -h / 2 * (body.inverse_inertia * w.cross(spin_momentum(body))).cross(arm);
}

}  // namespace

WarmDirectContacts exact_direct_contacts() {
  WarmDirectContacts direct;
  direct.tolerance = in_doubles ? 1e-11 : 1e-5;
  direct.too_far = in_doubles ? 1e-8 : 1e-4;
  direct.rounds = 6;
  return direct;
}

bool HeldContacts::holds(const ContactId& id) const {
  return !only || std::binary_search(only->begin(), only->end(),
                                     BodyPair(static_cast<int>(id.body_a), static_cast<int>(id.body_b)));
}

void HeldContacts::add_borne(const World& world, std::vector<Vec3>& accelerations) const {
  for (const Known& known : known_) {
    if (known.borne.isZero(0) || !holds(known.id)) continue;
    accelerations[known.id.body_a] -= world.bodies[known.id.body_a].inverse_mass * known.borne;
    accelerations[known.id.body_b] += world.bodies[known.id.body_b].inverse_mass * known.borne;
  }
}

void HeldContacts::look(const World& world) {
  for (std::size_t i = 0; i < known_.size(); ++i) {
    const Contact& contact = world.contacts[i];
    const auto [a, b] = world.bodies_of(contact);
    const Vec3 speed = b.velocity_at(contact.point) - a.velocity_at(contact.point);
    known_[i].approach = speed.dot(contact.normal);
    known_[i].slip = speed - known_[i].approach * contact.normal;
  }
}

void HeldContacts::begin(const World& world) {
  newton_.work = newton_.largest = most_work;
  newton_.near = 1e-3;
  newton_.forget();
  newton_.factored = 0;
  newton_.too_large = false;
  known_.clear();
  sums_.clear();
  auto old = world.contacts_before.begin();  // both lists ascend: walk them side by side
  for (const Contact& contact : world.contacts) {
    Known& known = known_.emplace_back(Known{.id = contact.id});
    while (old != world.contacts_before.end() && old->id < contact.id) ++old;
    if (old != world.contacts_before.end() && old->id == contact.id)
      known.borne = world.impulse_scale(1) * old->impulse;
  }
}

/// N s, on B, world axes.
void HeldContacts::add_up(const World& world, std::size_t contact, const Vec3& impulse) {
  std::size_t& at = known_[contact].sum;
  if (at == none) at = sums_.size(), sums_.emplace_back();
  const Vec3 sum = sums_[at].impulse + impulse;
  sums_[at] = world.contacts[contact];
  sums_[at].impulse = sum;
}

void HeldContacts::add(const World& world, std::size_t contact, const Vec3& impulses) {
  known_[contact].total += impulses;
  const Vec3& n = world.contacts[contact].normal;
  const auto [tangent1, tangent2] = tangents_of(n);
  add_up(world, contact, impulses[0] * n + impulses[1] * tangent1 + impulses[2] * tangent2);
}

void HeldContacts::detected(const World& world) {
  known_before_.swap(known_);
  known_.clear();
  auto old = known_before_.begin();
  for (const Contact& contact : world.contacts) {
    while (old != known_before_.end() && old->id < contact.id) ++old;
    if (old != known_before_.end() && old->id == contact.id) {
      known_.push_back(*old);
      continue;
    }
    known_.push_back({.id = contact.id});  // new since the step began: this is its approach
    known_.back().approach = separating_speed(world, contact);
  }
}

/// J v + b, m/s, world axes.
Vec3 HeldContacts::speed_of(const World& world, const Taking& taking) {
  const Contact& contact = world.contacts[taking.contact];
  const auto [a, b] = world.bodies_of(contact);
  return b.velocity_at(contact.point) - a.velocity_at(contact.point) + taking.bias * contact.normal + taking.turned;
}

/// The impulses of the stage before, on the bodies. What moves before them is q.
void HeldContacts::give_guess(World& world, Real h) {
  double largest = 0;
  for (const Taking& taking : taking_) {
    largest = std::max(largest, static_cast<double>(speed_of(world, taking).squaredNorm()));
  }
  unit_ = std::sqrt(largest);
  for (Taking& taking : taking_) {
    const Contact& contact = world.contacts[taking.contact];
    const auto [a, b] = world.bodies_of(contact);
    taking.impulse = h / 2 * known_[taking.contact].borne;
    if (static_cast<double>(taking.impulse.norm()) < direct_.tolerance * unit_)
      taking.impulse.setZero();  // it has parted
    if (taking.sliding()) taking.impulse = taking.impulse.dot(contact.normal) * pushes(contact, taking.slides);
    a.velocity -= a.inverse_mass * taking.impulse;
    a.angular_velocity -= a.inverse_inertia * (contact.point - a.position).cross(taking.impulse);
    b.velocity += b.inverse_mass * taking.impulse;
    b.angular_velocity += b.inverse_inertia * (contact.point - b.position).cross(taking.impulse);
  }
}

/// Chapter 16's relative_residual, of the worst contact.
double HeldContacts::off(const World& world) const {
  double largest = 0;
  for (const Taking& taking : taking_) {
    const Contact& contact = world.contacts[taking.contact];
    const Vec3 speed = speed_of(world, taking);
    if (taking.sliding()) {
      const Real r = taking.impulse.dot(contact.normal), u = speed.dot(contact.normal),
                 off = r - std::max(Real(0), r - u);
      largest = std::max(largest, static_cast<double>(off * off));
      if (speed.dot(taking.slides) < 0) return std::numeric_limits<double>::infinity();
      continue;
    }
    const Real mu = contact.friction, r_n = taking.impulse.dot(contact.normal), u_n = speed.dot(contact.normal);
    const Vec3 r_t = taking.impulse - r_n * contact.normal, u_t = speed - u_n * contact.normal;
    const Real s_n = u_n + mu * u_t.norm(), wanted_n = r_n - s_n;
    const Vec3 wanted_t = r_t - u_t;
    Real squared = s_n * s_n + u_t.squaredNorm();
    if (wanted_n < 0 || wanted_t.squaredNorm() > mu * mu * wanted_n * wanted_n) {  // outside of the cone
      const Vec3 wanted(wanted_n, wanted_t.norm(), 0),
          nearest = projected_to_cone(wanted.cast<double>(), static_cast<double>(mu)).cast<Real>();
      const Vec3 way = wanted[1] > 0 ? Vec3(wanted_t / wanted[1]) : Vec3::Zero();
      squared = (r_n - nearest[0]) * (r_n - nearest[0]) + (r_t - nearest[1] * way).squaredNorm();
    }
    largest = std::max(largest, static_cast<double>(squared));
  }
  return std::sqrt(largest) / (unit_ > 0 ? unit_ : 1);
}

/// Of what takes part: the normals, then the tangents of those that do not slide. The impulses are on the bodies.
void HeldContacts::place(World& world) {
  rows_.clear();
  const auto add = [&](std::size_t k, const Vec3& direction) {
    rows_.emplace_back(world, world.contacts[taking_[k].contact], direction, k);
    rows_.back().impulse = taking_[k].impulse.dot(direction);
    rows_.back().bias = taking_[k].turned.dot(direction);
  };
  for (std::size_t k = 0; k < taking_.size(); ++k) {
    Taking& taking = taking_[k];
    const Contact& contact = world.contacts[taking.contact];
    add(k, contact.normal);
    Row& row = rows_.back();
    row.bias = taking.bias;
    if (!taking.sliding()) continue;
    const Row aside(world, contact, taking.slides, k);  // asked for along n, it acts along n - mu t
    row.dva -= contact.friction * aside.dva;
    row.dwa -= contact.friction * aside.dwa;
    row.dvb -= contact.friction * aside.dvb;
    row.dwb -= contact.friction * aside.dwb;
  }
  for (std::size_t k = 0; k < taking_.size(); ++k) {
    if (taking_[k].sliding()) continue;
    const auto [tangent1, tangent2] = tangents_of(world.contacts[taking_[k].contact].normal);
    add(k, tangent1);
    add(k, tangent2);
  }
}

void HeldContacts::add_to(NewtonFromGuess& newton, World& world) {
  place(world);
  std::size_t tangent = taking_.size();
  for (std::size_t k = 0; k < taking_.size(); ++k) {
    if (taking_[k].sliding()) {
      newton.add_normal(rows_[k]);
      continue;
    }
    newton.add_contact(rows_[k], rows_[tangent], rows_[tangent + 1], world.contacts[taking_[k].contact].friction);
    tangent += 2;
  }
}

void HeldContacts::take(const World& world) {
  for (Taking& taking : taking_) taking.impulse.setZero();
  for (const Row& row : rows_) {
    Taking& taking = taking_[row.owner];
    taking.impulse += row.impulse * (taking.sliding() ? pushes(world.contacts[taking.contact], taking.slides) : row.n);
  }
}

bool HeldContacts::turns_back(const World& world) {
  bool any = false;
  for (Taking& taking : taking_) {
    if (!taking.sliding()) continue;
    if (speed_of(world, taking).dot(taking.slides) >= 0) continue;
    taking.slides.setZero();
    any = true;
  }
  return any;
}

/// From the guess by Newton's method, and where that does not get there, as chapter 17 does.
bool HeldContacts::solve_rows(World& world, Real h) {
  do {
    newton_.clear();
    add_to(newton_, world);
    newton_.solve(world, direct_.tolerance * unit_ / 16, direct_.too_far * unit_ / 16);
    take(world);
  } while (turns_back(world));
  if (off(world) <= direct_.too_far) return true;
  if (fall_back_to_full_solve) return solve_from_nothing(world, h);
  failure_ = fmt::format("{} contacts are not solved from what they bore", taking_.size());
  return false;
}

void HeldContacts::find_out() {
  for (Taking& taking : taking_) taking.slides.setZero();
}

bool HeldContacts::solve_from_nothing(World& world, Real h) {
  find_out();
  place(world);
  touching_.clear();
  for (const Taking& taking : taking_) touching_.push_back(world.contacts[taking.contact]);
  world.contacts.swap(touching_);  // chapter 17 solves those of the world
  StepContext step{world, world.contacts, rows_, h};
  direct_.work = newton_.work;
  failure_ = direct_.try_start(step) ? "" : WarmDirectContacts::too_large(taking_.size());
  for (std::size_t k = 0; k < taking_.size() && failure_.empty(); ++k) {
    const ContactId& id = world.contacts[k].id;
    if (!(step.speed_error(k) > -solved))
      failure_ = fmt::format("where bodies {} and {} touch, {} m/s are left: half steps need solved contacts",
                             id.body_a, id.body_b, -step.speed_error(k));
  }
  world.contacts.swap(touching_);
  if (!failure_.empty()) return false;
  newton_.work = direct_.work;
  take(world);
  return true;
}

bool HeldContacts::press(World& world, Real h) {
  begin_pressing(world, h);
  if (!(off(world) <= direct_.tolerance) && !solve_rows(world, h)) return false;
  end_pressing(world, h);
  return true;
}

bool HeldContacts::project(World& world, Real h) {
  begin_projecting(world, h);
  if (!(off(world) <= direct_.tolerance) && !solve_rows(world, h)) return false;
  end_projecting(world, h);
  return true;
}

/// What overlaps comes out by a tenth in a hundredth of a second, or no faster than the second half of the kick takes back: h g / 4.
/// Its speed is lost to friction, so slowly is better than at once.
void HeldContacts::begin_pressing(World& world, Real h) {
  const Real fastest = h * world.gravity.norm() / 4;
  taking_.clear();
  for (std::size_t i = 0; i < known_.size(); ++i) {
    known_[i].pressed = false;
    if (!holds(known_[i].id)) {
      known_[i].borne.setZero();
      continue;
    }
    const Real depth = world.contacts[i].depth, gap = std::abs(depth) > level ? -depth : 0;
    const Real slip = known_[i].slip.norm();
    const bool slides = slip > creeps && world.contacts[i].friction > 0;
    const Real bias = (gap < 0 ? -std::min({-gap / h, -10 * gap, fastest}) : gap / h) - known_[i].bends / h;
    known_[i].bends = 0;
    const Vec3& n = world.contacts[i].normal;
    const Vec3 sideways = slides ? Vec3(known_[i].slip / slip) : Vec3::Zero();
    taking_.push_back({i, bias, Vec3::Zero(), Vec3::Zero(), sideways});
    if (slides || world.contacts[i].friction == 0) continue;
    const auto [a, b] = world.bodies_of(world.contacts[i]);
    const Vec3& at = world.contacts[i].point;
    const Vec3 turned = gained_in_drift(b, at - b.position, h) - gained_in_drift(a, at - a.position, h);
    taking_.back().turned = turned - turned.dot(n) * n;
  }
  give_guess(world, h);
}

void HeldContacts::end_pressing(const World& world, Real h) {
  for (const Taking& taking : taking_) {
    Known& known = known_[taking.contact];
    known.pressing = taking.impulse;
    known.total += components(taking.impulse, world.contacts[taking.contact].normal);
    add_up(world, taking.contact, taking.impulse);
    if (known.borne.isZero(0)) known.borne = 2 / h * taking.impulse;
    known.pressed = taking.impulse.dot(world.contacts[taking.contact].normal) > 0;
  }
}

void HeldContacts::begin_projecting(World& world, Real h) {
  taking_.clear();
  for (std::size_t i = 0; i < known_.size(); ++i) {
    Known& known = known_[i];
    known.last.setZero();
    if (!holds(known.id) || (!known.pressed && world.contacts[i].depth <= -touches)) {
      known.borne.setZero();
      continue;
    }
    const bool bounces = known.approach < -threshold;
    const Real bias = bounces ? world.contacts[i].restitution * known.approach : 0;
    taking_.push_back({i, bias, Vec3::Zero(), Vec3::Zero(), Vec3::Zero()});
  }
  give_guess(world, h);
}

void HeldContacts::end_projecting(const World& world, Real h) {
  for (const Taking& taking : taking_) {
    Known& known = known_[taking.contact];
    known.total += components(taking.impulse, world.contacts[taking.contact].normal);
    add_up(world, taking.contact, taking.impulse);
    known.last = taking.impulse;
    known.borne = (known.pressing + taking.impulse) / h;
  }
}

void HeldContacts::report(World& world) const {
  constexpr Real rounding = in_doubles ? Real(1e-6) : Real(1e-3);  // of what was drawn back to the cone
  for (std::size_t i = 0; i < known_.size(); ++i) {
    Contact& contact = world.contacts[i];
    const Vec3& total = known_[i].total;
    contact.impulse.setZero();
    if (total[0] <= 0) continue;
    const auto [tangent1, tangent2] = tangents_of(contact.normal);
    const Real most = contact.friction * total[0], rubbed = std::hypot(total[1], total[2]);
    const Real within = rubbed > most ? most / rubbed : 1;  // to rounding, each stage was
    contact.impulse = total[0] * contact.normal + within * (total[1] * tangent1 + total[2] * tangent2);
    const Real normal = known_[i].last.dot(contact.normal);
    const Real aside = (known_[i].last - normal * contact.normal).norm();
    if (normal <= 0 || contact.friction <= 0) continue;  // nothing sticks or slides
    contact.state = aside < (1 - rounding) * contact.friction * normal ? ContactState::sticking : ContactState::sliding;
  }
}

void HeldContacts::report_sums(World& world) const {
  Contacts sums = sums_;
  std::stable_sort(sums.begin(), sums.end(), [](const Contact& p, const Contact& q) { return p.id < q.id; });
  Contacts all;
  auto sum = sums.begin();  // both lists ascend: walk them side by side
  const auto parted = [&] {
    if (!all.empty() && all.back().id == sum->id) return void(all.back().impulse += sum->impulse);  // it had come back
    all.push_back(*sum);
    all.back().parted = true;
    all.back().last_impulse.setZero();
  };
  for (const Contact& contact : world.contacts) {
    for (; sum != sums.end() && sum->id < contact.id; ++sum) parted();
    all.push_back(contact);
    all.back().impulse.setZero();
    for (; sum != sums.end() && sum->id == contact.id; ++sum) all.back().impulse += sum->impulse;
  }
  for (; sum != sums.end(); ++sum) parted();
  std::erase_if(all, [](const Contact& contact) { return contact.parted && contact.impulse.isZero(0); });
  world.contacts.swap(all);
}

}  // namespace pushback
