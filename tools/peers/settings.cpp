#include "pushback/tools/peers/peer.h"

namespace pushback {

std::vector<PeerSetting> settings_of_peer() {
  std::vector<PeerSetting> all = peer_settings();
  all.insert(all.end(), settings_from_source().begin(), settings_from_source().end());
  return all;
}

}  // namespace pushback
