#include "pushback/tools/measure/peers/peer.h"

namespace pushback {

std::vector<PeerSetting> settings_of_peer() {
  return peer_settings();
}

}  // namespace pushback
