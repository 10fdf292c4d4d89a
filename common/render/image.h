/// A picture as pixels, with functions that write and read PNG files.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace pushback {

/// 8 bits each of red, green and blue (sRGB) and 8 unused bits, rows from the top, no padding.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> pixels;  ///< 4 * width * height

  Image() = default;
  /// Filled with one grey level, by default white. Throws InvalidInput if a side is below 1 or above 16384.
  Image(int wide, int high, std::uint8_t level = 255);
  std::uint8_t* at(int x, int y) {
    return pixels.data() +
           4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x));
  }
  const std::uint8_t* at(int x, int y) const { return const_cast<Image*>(this)->at(x, y); }
};

/// The difference between two images of the same size.
struct Difference {
  double mean = 0;   ///< absolute difference in levels of 255, over all channels
  double share = 0;  ///< fraction of the pixels that differ in a channel by more than `clearly` levels
};
/// Compares averages over squares of `block` x `block` pixels. Throws InvalidInput if the images have different sizes.
Difference difference(const Image& a, const Image& b, int block = 1, int clearly = 24);

/// Converts to and from the bytes of a PNG. from_png throws InvalidInput, with `name`, if the bytes are not a PNG.
std::string in_png(const Image& image);
Image from_png(const std::string& bytes, const std::string& name);
/// Throws InvalidInput, naming the file, if it cannot be written. It leaves no half-written file behind.
void write_png(const std::filesystem::path& file, const Image& image);
/// Throws InvalidInput, naming the file, if it cannot be read.
Image read_png(const std::filesystem::path& file);

}  // namespace pushback
