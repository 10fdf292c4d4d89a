/// A picture as pixels, and its way to and from a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pushback {

/// 8 bits each of red, green and blue (sRGB) and 8 that mean nothing, rows from the top, no padding.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  ///< 4 * width * height

  Image() = default;
  /// Filled with one grey level; white unless told. Throws InvalidInput where a side is below 1 or above 16384.
  Image(int wide, int high, std::uint8_t level = 255);
  std::uint8_t* at(int x, int y) {
    return pixels.data() +
           4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }
  const std::uint8_t* at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }
};

/// How far two images of one size are apart.
struct Difference {
  double mean = 0;   ///< levels of 255, over all channels
  double share = 0;  ///< of the pixels, those that differ clearly: in a channel by more than so many levels
};
/// Of averages over squares of `block` pixels each way. Throws InvalidInput where the images have two sizes.
Difference difference(const Image& a, const Image& b, int block = 1, int clearly = 24);

/// As the bytes of a PNG, and back. Throws InvalidInput, with `name`, where the bytes are none.
std::string in_png(const Image& image);
Image from_png(const std::string& bytes, const std::string& name);
/// Throws InvalidInput, naming the file, where it cannot be written; then no file is left behind half-written.
void write_png(const std::filesystem::path& file, const Image& image);
/// Throws InvalidInput, naming the file, where it cannot be read.
Image read_png(const std::filesystem::path& file);

}  // namespace pushback
