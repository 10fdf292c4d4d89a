// Images, text, and what can be seen in a picture.
#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "pushback/common/basics/input.h"
#include "pushback/common/render/canvas.h"
#include "pushback/common/render/image.h"
#include "pushback/common/render/painter.h"
#include "pushback/common/render/palette.h"
#include "tests/support/call.h"
#include "tests/support/colour_blind.h"

using namespace pushback;

namespace {

/// How many pixels two images of one size do not share.
int differences(const Image& a, const Image& b) {
  REQUIRE(a.pixels.size() == b.pixels.size());
  int count = 0;
  for (std::size_t i = 0; i < a.pixels.size(); i += 4) {
    if (a.pixels[i] != b.pixels[i] || a.pixels[i + 1] != b.pixels[i + 1] || a.pixels[i + 2] != b.pixels[i + 2]) ++count;
  }
  return count;
}

Solid floor_at_zero() {
  return {HalfSpace{Vec3(0, 1, 0)}, Vec3::Zero(), Quat::Identity(), fixed_colour()};
}

Picture ball_in_the_air() {
  Picture picture;
  picture.camera = {Vec3(0, 1, 6), Vec3(0, 1, 0), Real(0.6)};
  picture.solids.push_back({Sphere{Real(0.5)}, Vec3(0, 1, 0), Quat::Identity(), Colour{0.7f, 0.02f, 0.02f}});
  return picture;
}

}  // namespace

TEST_CASE("a PNG gives back the pixels it was given") {
  const Scratch folder;
  Image image(37, 21);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) image.pixels[i] = static_cast<std::uint8_t>(i * 31 % 251);
  const fs::path file = folder / "there and back.png";
  write_png(file, image);
  write_png(file, image);  // a second time replaces the first
  const Image back = read_png(file);
  CHECK(back.width == 37);
  CHECK(back.height == 21);
  CHECK(differences(back, image) == 0);
}

TEST_CASE("a PNG that cannot be written leaves nothing behind") {
  const Scratch folder;
  const Image image(4, 4);
  CHECK_THROWS_AS(write_png(folder / "missing/a.png", image), InvalidInput);
  CHECK_FALSE(fs::exists(folder / "missing"));
  fs::create_directories(folder / "taken.png/by a folder");
  CHECK_THROWS_AS(write_png(folder / "taken.png", image), InvalidInput);
  CHECK(std::distance(fs::directory_iterator(folder / ""), fs::directory_iterator()) == 1);
  CHECK_THROWS_AS(write_png(folder / "empty.png", Image()), InvalidInput);
}

TEST_CASE("what is not a PNG is refused by name") {
  const Scratch folder;
  const fs::path file = folder / "words.png";
  std::ofstream(file) << "these are words";
  CHECK_THROWS_AS(read_png(file), InvalidInput);
  CHECK_THROWS_AS(read_png(folder / "absent.png"), InvalidInput);
  try {
    read_png(folder / "absent.png");
  } catch (const InvalidInput& refusal) {
    CHECK(std::string(refusal.what()).find("absent.png") != std::string::npos);
  }
}

TEST_CASE("resizing averages levels, in each colour, and keeps an even image as it is") {
  Image image(120, 80, 0);
  for (int y = 0; y < 80; ++y) {
    for (int x = 0; x < 120; ++x) {
      image.at(x, y)[0] = (x + y) % 2 == 0 ? 255 : 0;
      image.at(x, y)[1] = x < 60 ? 90 : 200;
    }
  }
  const Image small = resized(image, 40, 30);
  for (const int x : {0, 7, 18, 21, 39}) {
    CHECK(small.at(x, 11)[0] == Approx(127.5).margin(20));
    CHECK(small.at(x, 11)[1] == (x < 20 ? 90 : 200));
    CHECK(small.at(x, 11)[2] == 0);
  }
  CHECK(differences(resized(Image(7, 5, 97), 13, 3), Image(13, 3, 97)) == 0);
  CHECK(differences(resized(image, 120, 80), image) == 0);
}

TEST_CASE("a red ball in front of the camera is red in the middle, with the background around it") {
  Painter painter(160, 90);
  const Picture picture = ball_in_the_air();
  for (const Image& image : {painter.draw(picture), painter.draw_still(picture, 4)}) {
    const std::uint8_t* middle = image.at(80, 45);
    CHECK(middle[0] > 120);
    CHECK(middle[0] > 2 * middle[1]);
    CHECK(middle[0] > 2 * middle[2]);
    const std::uint8_t* corner = image.at(2, 2);
    CHECK(corner[0] > 200);
    CHECK(std::abs(corner[0] - corner[1]) < 20);
  }
}

TEST_CASE("the same picture is the same bytes, whoever draws it and whatever was drawn before") {
  Picture picture = ball_in_the_air();
  picture.solids.push_back(floor_at_zero());
  picture.arrows.push_back({Vec3(0, 0, 0), Vec3(0, 2, 0), Real(0.05), normal_arrow_colour()});
  picture.dots.push_back({Vec3(0, 0, 0), Real(0.05), contact_colour(ContactState::warm)});
  Painter first(120, 68), second(120, 68);
  const Image once = first.draw(picture);
  const Image still = first.draw_still(picture, 3);
  CHECK(differences(first.draw(picture), once) == 0);
  CHECK(differences(second.draw(picture), once) == 0);
  CHECK(differences(second.draw_still(picture, 3), still) == 0);
}

TEST_CASE("a slanted half-space is seen from outside and not from inside") {
  Painter painter(160, 90);
  Picture picture;
  picture.camera = {Vec3(0, 3, 8), Vec3::Zero(), Real(0.6)};
  const Image empty = painter.draw(picture);
  const Vec3 normal = Vec3(Real(-0.4), 1, 0).normalized();
  picture.solids.push_back({HalfSpace{normal}, Vec3::Zero(), Quat::Identity(), fixed_colour()});
  CHECK(differences(painter.draw(picture), empty) > 2000);
  picture.solids[0] = {HalfSpace{-normal}, Vec3::Zero(), Quat::Identity(), fixed_colour()};
  CHECK(differences(painter.draw(picture), empty) == 0);
}

TEST_CASE("a world that blew up can still be drawn") {
  Painter painter(64, 36);
  Picture picture = ball_in_the_air();
  const Image before = painter.draw(picture);
  const Real nan = std::numeric_limits<Real>::quiet_NaN(), infinite = std::numeric_limits<Real>::infinity();
  picture.solids.push_back({Sphere{Real(0.5)}, Vec3(nan, 0, 0), Quat::Identity(), body_colour(0)});
  picture.solids.push_back({Box{Vec3(1, 1, 1)}, Vec3(infinite, 0, 0), Quat::Identity(), body_colour(0)});
  picture.solids.push_back({Box{Vec3(1, 1, 1)}, Vec3(0, 0, 0), Quat(nan, 0, 0, 0), body_colour(0)});
  picture.arrows.push_back({Vec3::Zero(), Vec3(0, infinite, 0), Real(0.1), normal_arrow_colour()});
  picture.arrows.push_back({Vec3::Zero(), Vec3::Zero(), Real(0.1), normal_arrow_colour()});
  picture.dots.push_back({Vec3(0, nan, 0), Real(0.1), normal_arrow_colour()});
  CHECK(differences(painter.draw(picture), before) == 0);
}

TEST_CASE("a camera that looks at nothing is refused") {
  Painter painter(16, 9);
  Picture picture;
  picture.camera.target = picture.camera.eye;
  CHECK_THROWS_AS(painter.draw(picture), InvalidInput);
  picture.camera = {Vec3(0, std::numeric_limits<Real>::quiet_NaN(), 0), Vec3::Zero(), Real(0.6)};
  CHECK_THROWS_AS(painter.draw(picture), InvalidInput);
  picture.camera = {Vec3(0, 1, 1), Vec3::Zero(), 0};
  CHECK_THROWS_AS(painter.draw(picture), InvalidInput);
  picture.camera = Camera();
  CHECK_THROWS_AS(painter.draw_still(picture, 0), InvalidInput);
}

TEST_CASE("what contacts, arrows and bodies are coloured stays apart for the colour-blind") {
  const std::array states{contact_ink(ContactState::fresh), contact_ink(ContactState::warm),
                          contact_ink(ContactState::sliding), contact_ink(ContactState::sticking)};
  const std::array arrows{normal_arrow_ink(), friction_arrow_ink()};
  std::vector<Ink> bodies{asleep_ink(), fixed_ink()};
  for (int i = 0; i < 6; ++i) bodies.push_back(body_ink(i));
  for (const Mat3& eyes : ways_to_see()) {
    CHECK(apart(arrows[0], arrows[1], eyes) > 34);
    for (std::size_t i = 0; i < states.size(); ++i) {
      for (std::size_t k = 0; k < i; ++k) CHECK(apart(states[i], states[k], eyes) > 44);
      for (const Ink arrow : arrows) CHECK(apart(states[i], arrow, eyes) > 19);  // chapter 22 has a set in each
    }
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      INFO("body " << i);
      for (const Ink state : states) CHECK(apart(state, bodies[i], eyes) > 19);
      for (const Ink arrow : arrows) CHECK(apart(arrow, bodies[i], eyes) > 19);
      for (std::size_t k = 0; k < i; ++k)
        CHECK(apart(bodies[i], bodies[k], eyes) > 13);  // they are lit and shaded, too
    }
    for (const auto& [one, other] : {std::pair{body_ink(3), near_black_ink()}, {body_ink(2), asleep_ink()}})
      CHECK(apart(one, other, eyes) > 60);  // what strips tell apart: new and missing contacts, awake and asleep
  }
}
