#pragma once

namespace leitstand::detail {

/// Mends two defects of Fast DDS (2.9 of Debian 12, 3.1 of Debian 13) that end or silence a process when the
/// last one who hears a topic goes. This program has functions under names of the library's, which the
/// library calls in place of its own; they pass on to those.
///
/// A packet with nobody left to go to: flow controllers send what they gathered without the writer's lock;
/// where the last reader went meanwhile, `SecurityManager::encode_rtps_message` asserts that there is one.
/// Here it is an error as any other, and the packet is not sent.
///
/// Two locks in two orders: `StatefulWriter::matched_reader_remove` holds the list of addresses while
/// `check_acked_status` removes samples from the flow controller's queue, which takes the queue's lock; the
/// queue's thread holds that lock while it waits for the list to send. Both wait for ever, and all who write
/// with them. Here the check follows when the list is free again, and nobody else checks meanwhile.
///
/// False when the library does not call them: it is another version, or was linked otherwise.
[[nodiscard]] bool mendsTheLibrary();

}  // namespace leitstand::detail
