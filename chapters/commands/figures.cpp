/// ./course figures: draws the figures of the pages anew, into docs/figures/.
#include "pushback/chapters/commands/figures/figures.h"
#include "pushback/common/basics/files.h"
#include "pushback/common/experiment/program.h"

using namespace pushback;
using namespace pushback::figures;

int main(int argc, char** argv) {
  CLI::App app{"Draws the figures of the pages."};
  std::filesystem::path out = "docs/figures";
  app.add_option("--out", out, "The folder to write to")->capture_default_str();
  return run_program(app, argc, argv, [&] {
    make_writable_folder(out);
    for (const Figure& figure : all_figures()) write_text_file(out / figure.file, figure.draw());
    fmt::print("{} figures are in {}\n", all_figures().size(), out.string());
  });
}
