#include "pushback/common/render/mesh.h"

#include <cmath>

namespace pushback {
namespace {

using Eigen::Vector3f;

void add_triangle(Mesh& mesh, std::size_t a, std::size_t b, std::size_t c) {
  for (const std::size_t index : {a, b, c}) mesh.indices.push_back(static_cast<std::uint16_t>(index));
}

/// A place on a grid line across one face of a box: the corner to which it belongs, -1 or 1, and how far the normal leans towards that
/// side.
struct Lean {
  float corner, slope;
};

std::vector<Lean> leans(int steps) {
  if (steps == 0) return {{-1, 1}, {1, 1}};
  std::vector<Lean> line;
  for (int i = steps; i >= 0; --i)
    line.push_back({-1, std::tan(static_cast<float>(pi) / 4 * static_cast<float>(i) / static_cast<float>(steps))});
  for (int i = 0; i <= steps; ++i) line.push_back({1, line[static_cast<std::size_t>(steps - i)].slope});
  return line;
}

void add_disc(Mesh& mesh, int sides) {
  const std::size_t first = mesh.vertices.size();
  for (int i = 0; i < sides; ++i) {
    const float angle = 2 * static_cast<float>(pi) * static_cast<float>(i) / static_cast<float>(sides);
    mesh.vertices.push_back({{std::cos(angle), -1, std::sin(angle)}, {0, -1, 0}});
  }
  for (std::size_t i = 2; i < static_cast<std::size_t>(sides); ++i) add_triangle(mesh, first, first + i - 1, first + i);
}

}  // namespace

Mesh rounded_box(int steps) {
  Mesh mesh;
  const std::vector<Lean> line = leans(steps);
  const std::size_t width = line.size();
  for (int face = 0; face < 6; ++face) {
    const int axis = face / 2;
    const float side = face % 2 == 0 ? 1.0f : -1.0f;
    const Vector3f out = side * Vector3f::Unit(axis);
    const Vector3f right = Vector3f::Unit((axis + 1) % 3), up = out.cross(right);
    const std::size_t first = mesh.vertices.size();
    for (const Lean& v : line) {
      for (const Lean& u : line) {
        const Vector3f corner = out + u.corner * right + v.corner * up;
        const Vector3f normal = out + u.corner * u.slope * right + v.corner * v.slope * up;
        mesh.vertices.push_back({corner, steps == 0 ? Vector3f(0.65f * normal) : normal.normalized()});
      }
    }
    for (std::size_t row = 0; row + 1 < width; ++row) {
      for (std::size_t column = 0; column + 1 < width; ++column) {
        const std::size_t here = first + row * width + column;
        add_triangle(mesh, here, here + 1, here + width + 1);
        add_triangle(mesh, here, here + width + 1, here + width);
      }
    }
  }
  return mesh;
}

Mesh shaft(int sides) {
  Mesh mesh;
  for (int i = 0; i <= sides; ++i) {
    const float angle = 2 * static_cast<float>(pi) * static_cast<float>(i) / static_cast<float>(sides);
    const Vector3f out(std::cos(angle), 0, std::sin(angle));
    mesh.vertices.push_back({out - Vector3f::UnitY(), out});
    mesh.vertices.push_back({out + Vector3f::UnitY(), out});
  }
  for (std::size_t i = 0; i < 2 * static_cast<std::size_t>(sides); i += 2) {
    add_triangle(mesh, i, i + 1, i + 3);
    add_triangle(mesh, i, i + 3, i + 2);
  }
  add_disc(mesh, sides);
  return mesh;
}

Mesh cone(int sides, float slimness) {
  Mesh mesh;
  for (int i = 0; i <= sides; ++i) {
    const auto out = [&](float step) {
      const float angle = 2 * static_cast<float>(pi) * step / static_cast<float>(sides);
      return Vector3f(std::cos(angle), 0, std::sin(angle));
    };
    const auto normal = [&](const Vector3f& direction) {
      return (slimness * direction + Vector3f::UnitY()).normalized();
    };
    const float step = static_cast<float>(i);
    mesh.vertices.push_back({out(step) - Vector3f::UnitY(), normal(out(step))});
    mesh.vertices.push_back({Vector3f::UnitY(), normal(out(step + 0.5f))});  // each facet has a tip of its own
  }
  for (std::size_t i = 0; i < 2 * static_cast<std::size_t>(sides); i += 2) add_triangle(mesh, i, i + 1, i + 2);
  add_disc(mesh, sides);
  return mesh;
}

}  // namespace pushback
