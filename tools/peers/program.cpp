/// The programs `motion_bullet`, `motion_ode` ...: another engine plays motions.
#include "pushback/tools/peers/peer.h"

int main(int argc, char** argv) {
  return pushback::play_program(argc, argv, "Plays a motion by another engine: how far from the truth, in what time.",
                                pushback::peer_version(), pushback::peer_methods());
}
