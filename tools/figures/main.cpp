/// ./course figures: draws the figures of the pages anew, into docs/figures/.
#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/program.h"
#include "pushback/tools/figures/figures.h"

using namespace pushback;
using namespace pushback::figures;

int main(int argc, char** argv) {
  CommandLine line("Draws the figures of the pages.");
  std::filesystem::path out = "docs/figures";
  line.option("--out", out, "The folder to write to").shows_default();
  return line.run(argc, argv, [&] {
    make_writable_folder(out);
    for (const Figure& figure : all_figures()) write_text_file(out / figure.file, figure.draw());
    fmt::print("{} figures are in {}\n", all_figures().size(), out.string());
  });
}
