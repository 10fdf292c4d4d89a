#include "pushback/tools/classroom/mine/below_mistakes.h"

#include "pushback/docs/from_an_empty_file/names.h"

namespace pushback {

namespace {

using empty_file::axes_of;
using empty_file::Axis;
using Theirs = Eigen::Vector3d;
using Body = empty_file::Body;
using Turned = empty_file::Quat;

OwnBodies with(const std::function<void(OwnBodies&)>& change) {
  OwnBodies made = bodies_of_pages();
  change(made);
  return made;
}

/// As the page's `move`, but for how it turns, which is given ω and h.
OwnBodies turning(const std::function<void(Body&, double)>& turn) {
  return with([turn](OwnBodies& made) {
    made.move = [turn](OwnBody& own, Real h) {
      Body body = as_theirs<Body>(own);
      if (body.inverse_mass > 0) {
        body.position += static_cast<double>(h) * body.velocity;
        turn(body, static_cast<double>(h));
      }
      own = as_ours(body);
    };
  });
}

Theirs momentum_of(const Body& body) {
  return axes_of(body) * (axes_of(body).transpose() * body.angular_velocity).cwiseQuotient(body.inverse_inertia);
}

OwnBodies pushing(const std::function<void(Body&, const Theirs& impulse, const Theirs& point)>& push) {
  return with([push](OwnBodies& made) {
    made.push = [push](OwnBody& own, const Vec3& impulse, const Vec3& point) {
      Body body = as_theirs<Body>(own);
      push(body, impulse.cast<double>(), point.cast<double>());
      own = as_ours(body);
    };
  });
}

/// Each of the pages' points, changed, whatever touches.
OwnBodies changing(const std::function<void(OwnTouches&)>& change) {
  return with([change](OwnBodies& made) {
    const OwnBodies right = made;
    const auto changed = [change](OwnTouches touches) {
      change(touches);
      return touches;
    };
    made.plane_and_ball = [=](const Vec3& n, Real o, const Vec3& c, Real r) {
      return changed(right.plane_and_ball(n, o, c, r));
    };
    made.balls = [=](const Vec3& a, Real ra, const Vec3& b, Real rb) { return changed(right.balls(a, ra, b, rb)); };
    made.plane_and_box = [=](const Vec3& n, Real o, const OwnBody& b) { return changed(right.plane_and_box(n, o, b)); };
    made.least_overlap = [=](const OwnBody& a, const OwnBody& b) { return changed(right.least_overlap(a, b)); };
    made.edges = [=](const OwnBody& a, const OwnBody& b) { return changed(right.edges(a, b)); };
    made.boxes = [=](const OwnBody& a, const OwnBody& b) { return changed(right.boxes(a, b)); };
  });
}

OwnBodies changing_each(const std::function<void(OwnTouch&)>& change) {
  return changing([change](OwnTouches& touches) {
    for (OwnTouch& one : touches) change(one);
  });
}

/// Names of points of boxes alone.
OwnBodies naming(const std::function<void(OwnTouches&)>& change) {
  return with([change](OwnBodies& made) {
    made.boxes = [change, right = made.boxes](const OwnBody& a, const OwnBody& b) {
      OwnTouches touches = right(a, b);
      change(touches);
      return touches;
    };
  });
}

/// Two boxes, with another choice of axis, or without the clipping.
struct Boxes {
  bool edges = true, of_length_one = true, clipped = true;

  bool least(const Body& a, const Body& b, Axis& least) const {
    const Theirs way = b.position - a.position;
    const auto overlaps = [&](Theirs n, int axis_a, int axis_b) {
      if (n.norm() < 1e-5) return true;
      if (of_length_one) n.normalize();
      if (n.dot(way) < 0) n = -n;
      const double depth = empty_file::reach(a, n) + empty_file::reach(b, n) - n.dot(way);
      if (depth < least.depth - 1e-4) least = {n, depth, axis_a, axis_b};
      return depth >= 0;
    };
    const auto of_a = axes_of(a), of_b = axes_of(b);
    for (int i = 0; i < 3; ++i)
      if (!overlaps(of_a.col(i), i, -1) || !overlaps(of_b.col(i), -1, i)) return false;
    for (int i = 0; edges && i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (!overlaps(of_a.col(i).cross(of_b.col(j)), i, j)) return false;
    return true;
  }
  empty_file::Touches touch(const Body& a, const Body& b) const {
    Axis axis;
    if (!least(a, b, axis)) return {};
    if (axis.of_edges()) return {empty_file::touch_of_edges(a, b, axis)};
    if (clipped) return empty_file::touch_of_faces(a, b, axis);
    const bool of_a = axis.axis_a >= 0;
    const Body &reference = of_a ? a : b, &incident = of_a ? b : a;
    const Theirs out = of_a ? axis.normal : -axis.normal;
    const double surface = reference.position.dot(out) + reference.half[of_a ? axis.axis_a : axis.axis_b];
    empty_file::Touches found;
    for (const auto& corner : empty_file::face_of(incident, -out))
      if (const double depth = surface - corner.at.dot(out); depth >= 0)
        found.push_back({corner.at + depth / 2 * out, axis.normal, depth, corner.name});
    return found;
  }
  OwnBodies answer() const {
    return with([all = *this](OwnBodies& made) {
      made.least_overlap = [all](const OwnBody& a, const OwnBody& b) -> OwnTouches {
        Axis axis;
        if (!all.least(as_theirs<Body>(a), as_theirs<Body>(b), axis)) return {};
        return {{Vec3::Zero(), axis.normal.cast<Real>(), static_cast<Real>(axis.depth), 0}};
      };
      made.edges = [all](const OwnBody& own_a, const OwnBody& own_b) -> OwnTouches {
        const Body a = as_theirs<Body>(own_a), b = as_theirs<Body>(own_b);
        Axis axis;
        if (!all.least(a, b, axis) || !axis.of_edges()) return {};
        return as_ours_of(std::vector{empty_file::touch_of_edges(a, b, axis)});
      };
      made.boxes = [all](const OwnBody& a, const OwnBody& b) {
        return as_ours_of(all.touch(as_theirs<Body>(a), as_theirs<Body>(b)));
      };
    });
  }
};

OwnBodies making(Real mass_by, Real inertia_by) {
  return with([=](OwnBodies& made) {
    made.box = [=, right = made.box](const Vec3& half, Real mass) {
      OwnBody body = right(half, mass);
      body.inverse_mass *= mass_by;
      body.inverse_inertia *= inertia_by;
      return body;
    };
  });
}

std::vector<MistakeOfPage> of_bodies() {
  return {
      {1,
       {"nothing yet", "this is the file as it began: nothing in it makes, pushes or moves a box.",
        with([](OwnBodies& made) {
          made.box = [](const Vec3&, Real) { return as_ours(Body{}); };
          made.push = [](OwnBody&, const Vec3&, const Vec3&) {};
          made.accelerate = [](OwnBody&, const Vec3&, Real) {};
          made.move = [](OwnBody&, Real) {};
        })}},
      {1,
       {"sides for half extents", "m/12 (b² + c²) is of whole sides. With half extents it is m/3 (b² + c²).",
        making(1, 4)}},
      {1,
       {"masses, not their inverses", "the inverses are kept: 1/m, and 1/I about each axis.", with([](OwnBodies& made) {
          made.box = [right = made.box](const Vec3& half, Real mass) {
            OwnBody body = right(half, mass);
            body.inverse_mass = mass;
            body.inverse_inertia = body.inverse_inertia.cwiseInverse();
            return body;
          };
        })}},
      {1,
       {"masses, not their inverses", "the inverses are kept: 1/m, and 1/I about each axis.", with([](OwnBodies& made) {
          made.box = [right = made.box](const Vec3& half, Real mass) {
            OwnBody body = right(half, mass);
            body.inverse_mass = mass;
            return body;
          };
        })}},
      {1,
       {"the axis's own extent",
        "the inertia about an axis is made of the two extents across it, not of those with the one along it.",
        with([](OwnBodies& made) {
          made.box = [right = made.box](const Vec3& half, Real mass) {
            OwnBody body = right(half, mass);
            const Vec3 s = half.cwiseProduct(half);
            for (int i = 0; i < 3; ++i) body.inverse_inertia[i] = 3 / (mass * (s[i] + s[(i + 1) % 3]));
            return body;
          };
        })}},
      {1,
       {"inertia of the body's axes",
        "I⁻¹ about the body's own axes met a torque in world axes: R I_body⁻¹ Rᵀ is what acts there.",
        pushing([](Body& body, const Theirs& impulse, const Theirs& point) {
          body.velocity += body.inverse_mass * impulse;
          body.angular_velocity += body.inverse_inertia.cwiseProduct((point - body.position).cross(impulse));
        })}},
      {1,
       {"turned the wrong way round", "Rᵀ I_body⁻¹ R turns the wrong way round: R has the body's axes as columns.",
        pushing([](Body& body, const Theirs& impulse, const Theirs& point) {
          const auto axes = axes_of(body);
          body.velocity += body.inverse_mass * impulse;
          body.angular_velocity +=
              axes.transpose() * body.inverse_inertia.asDiagonal() * axes * (point - body.position).cross(impulse);
        })}},
      {1,
       {"P × r", "the order of the cross product: the torque of an impulse is r × P.",
        pushing([](Body& body, const Theirs& impulse, const Theirs& point) {
          body.velocity += body.inverse_mass * impulse;
          body.angular_velocity += empty_file::world_inverse_inertia(body) * impulse.cross(point - body.position);
        })}},
      {1,
       {"arm from the origin", "the arm leads from the centre of mass to the point, not from the origin of the world.",
        pushing([](Body& body, const Theirs& impulse, const Theirs& point) {
          body.velocity += body.inverse_mass * impulse;
          body.angular_velocity += empty_file::world_inverse_inertia(body) * point.cross(impulse);
        })}},
      {1,
       {"no torque", "an impulse beside the centre turns the body, too: ω += I⁻¹ (r × P).",
        pushing(
            [](Body& body, const Theirs& impulse, const Theirs&) { body.velocity += body.inverse_mass * impulse; })}},
      {1,
       {"what nothing moves falls", "a body with an inverse mass of 0 is moved by nothing, not by gravity either.",
        with([](OwnBodies& made) {
          made.accelerate = [](OwnBody& own, const Vec3& gravity, Real h) { own.velocity += h * gravity; };
          made.move = [right = made.move](OwnBody& own, Real h) {
            if (own.inverse_mass > 0) right(own, h);
            else own.position += h * own.velocity;
          };
        })}},
      {1,
       {"what nothing moves falls", "a body with an inverse mass of 0 is moved by nothing, not by gravity either.",
        with([](OwnBodies& made) {
          made.accelerate = [](OwnBody& own, const Vec3& gravity, Real h) { own.velocity += h * gravity; };
        })}},
      {1,
       {"half a step more", "x += h v alone, with the new v: h²/2 of gravity is in nobody's symplectic Euler.",
        with([](OwnBodies& made) {
          made.accelerate = [](OwnBody& own, const Vec3& gravity, Real h) {
            if (own.inverse_mass == 0) return;
            own.velocity += h * gravity;
            own.position -= h * h / 2 * gravity;
          };
        })}},
      {1,
       {"ω kept", "ω stays as it is, but what a free body keeps is L = I ω: as I turns, ω changes.",
        turning([](Body& body, double h) {
          body.orientation = empty_file::turned(body.orientation, body.angular_velocity, h);
        })}},
      {1,
       {"ω kept", "ω stays as it is, but what a free body keeps is L = I ω: as I turns, ω changes.",
        turning([](Body& body, double h) {
          const Theirs momentum = momentum_of(body);
          const Turned start = body.orientation;
          body.orientation = empty_file::turned(start, body.angular_velocity, h / 2);
          body.orientation = empty_file::turned(start, empty_file::world_inverse_inertia(body) * momentum, h);
        })}},
      {1,
       {"ω of the start", "the turn is made with the ω of the step's start: take that of its middle.",
        turning([](Body& body, double h) {
          const Theirs momentum = momentum_of(body);
          body.orientation = empty_file::turned(body.orientation, body.angular_velocity, h);
          body.angular_velocity = empty_file::world_inverse_inertia(body) * momentum;
        })}},
      {1, {"never turned", "the orientation is not changed by ω.", turning([](Body&, double) {})}},
      {1,
       {"the quaternion grows", "the quaternion's length is never brought back to 1.",
        turning([](Body& body, double h) {
          const auto grown = [](Turned q, const Theirs& w, double time) {
            q.coeffs() += time / 2 * (Turned(0, w.x(), w.y(), w.z()) * q).coeffs();
            return q;
          };
          const Theirs momentum = momentum_of(body);
          const Turned start = body.orientation;
          body.orientation = grown(start, body.angular_velocity, h / 2);
          body.orientation = grown(start, empty_file::world_inverse_inertia(body) * momentum, h);
          body.angular_velocity = empty_file::world_inverse_inertia(body) * momentum;
        })}},
      {1,
       {"twice as fast", "the quaternion changes by half of (0, ω) q: it was turned by twice the angle.",
        turning([](Body& body, double h) {
          const Theirs momentum = momentum_of(body);
          const Turned start = body.orientation;
          body.orientation = empty_file::turned(start, 2 * body.angular_velocity, h / 2);
          body.orientation = empty_file::turned(start, 2 * (empty_file::world_inverse_inertia(body) * momentum), h);
          body.angular_velocity = empty_file::world_inverse_inertia(body) * momentum;
        })}},
      {1,
       {"q (0, ω)", "the order of the product: ω is in world axes, so (0, ω) stands before q.",
        turning([](Body& body, double h) {
          const auto other = [](const Turned& q, const Theirs& w, double time) {
            Turned made = q;
            made.coeffs() += time / 2 * (q * Turned(0, w.x(), w.y(), w.z())).coeffs();
            return made.normalized();
          };
          const Theirs momentum = momentum_of(body);
          const Turned start = body.orientation;
          body.orientation = other(start, body.angular_velocity, h / 2);
          body.orientation = other(start, empty_file::world_inverse_inertia(body) * momentum, h);
          body.angular_velocity = empty_file::world_inverse_inertia(body) * momentum;
        })}},
  };
}  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): it loses track of functions within a list

std::vector<MistakeOfPage> of_touches() {
  return {
      {2, {"no points", "no points were found where there are some.", changing([](OwnTouches& all) { all.clear(); })}},
      {2,
       {"from B to A", "the normal points from B to A: it has to point from A to B, always.",
        changing_each([](OwnTouch& one) { one.normal = -one.normal; })}},
      {2, {"depth below 0", "the depth has the wrong sign: an overlap is above 0.", changing_each([](OwnTouch& one) {
             one.depth = -one.depth;
           })}},
      {2,
       {"on the surface of A",
        "the point lies on the surface of A: midway between the surfaces, the arms of both are right.",
        changing_each([](OwnTouch& one) { one.point += one.depth / 2 * one.normal; })}},
      {2,
       {"on the surface of B",
        "the point lies on the surface of B: midway between the surfaces, the arms of both are right.",
        changing_each([](OwnTouch& one) { one.point -= one.depth / 2 * one.normal; })}},
      {2,
       {"the deepest alone", "one point, the deepest, is too few: on it a box would tip.",
        changing([](OwnTouches& all) {
          if (all.size() > 1)
            all = {*std::max_element(all.begin(), all.end(),
                                     [](const OwnTouch& a, const OwnTouch& b) { return a.depth < b.depth; })};
        })}},
      {2,
       {"six axes",
        "the nine cross products of edges are missing: with six axes an edge across an edge looks like a face.",
        Boxes{.edges = false}.answer()}},
      {2,
       {"cross products of any length",
        "a cross product of two edges is shorter than 1: depths along it are too small until "
        "it is brought to length 1.",
        Boxes{.of_length_one = false}.answer()}},
      {3,
       {"not clipped",
        "corners beside the other box are no points: the face is clipped at the four sides of the reference.",
        Boxes{.clipped = false}.answer()}},
  };
}

std::vector<MistakeOfPage> of_names() {
  constexpr int of_a_corner = 36;  // how many names a pair of faces has: see names.h
  return {
      {3, {"no points of boxes", "boxes were found to touch nowhere.", naming([](OwnTouches& all) { all.clear(); })}},
      {3, {"no names", "all points have one name: each inherits what the first had.", naming([](OwnTouches& all) {
             for (OwnTouch& one : all) one.name = 0;
           })}},
      {3,
       {"by place", "a point's place in the list is no name: it stays where the features change.",
        naming([](OwnTouches& all) {
          for (std::size_t i = 0; i < all.size(); ++i) all[i].name = static_cast<int>(i);
        })}},
      {3,
       {"faces left out",
        "the two faces are not part of the name: on the next face, points have the names of the old one.",
        naming([](OwnTouches& all) {
          for (OwnTouch& one : all) one.name = one.name >= 0 ? one.name % of_a_corner : one.name;
        })}},
      {3,
       {"new at each step", "names are counted on and on: no point is known again.",
        naming([count = 0](OwnTouches& all) mutable {
          for (OwnTouch& one : all) one.name = ++count;
        })}},
      {3,
       {"by where it is", "a name made of the point's coordinates changes as soon as the body moves.",
        naming([](OwnTouches& all) {
          for (OwnTouch& one : all) one.name = static_cast<int>(1e7 * (one.point.x() + 3 * one.point.y()));
        })}},
  };
}  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): it loses track of functions within a list

}  // namespace

OwnBodies bodies_of_pages() {
  using namespace empty_file;
  const auto made = [](const Theirs& half, double mass) { return empty_file::box(half, mass); };
  return own_names<empty_file::Body>(
      own_touches<empty_file::Body, Plane, Ball, Axis>(own_bodies<empty_file::Body>(made)));
}

std::vector<MistakeOfPage> mistakes_of_pages() {
  std::vector<MistakeOfPage> all = of_bodies();
  for (auto* more : {+of_touches, +of_names})
    for (MistakeOfPage& one : more()) all.push_back(std::move(one));
  return all;
}

}  // namespace pushback
