#pragma once

namespace leitstand::detail {

/// Mends two defects of Fast DDS (2.9 of Debian 12, 3.1 of Debian 13) that end or silence a process when the
/// last reader of a topic goes. This program defines functions with the names of three functions of the
/// library. The library calls them in place of its own, and they call the originals.
///
/// A packet without a receiver: flow controllers send what they gathered without the writer's lock. When the
/// last reader has gone meanwhile, `SecurityManager::encode_rtps_message` asserts that there is a receiver.
/// Here this is an error like any other, and the packet is not sent.
///
/// Two locks in two orders: `StatefulWriter::matched_reader_remove` holds the list of addresses while
/// `check_acked_status` removes samples from the flow controller's queue, which takes the queue's lock. The
/// queue's thread holds that lock while it waits for the list to send. Both threads wait for ever, and with
/// them all that write. Here the check is put off until the list is free again, and nobody else checks
/// meanwhile.
///
/// Returns false when the library does not call our functions: it is another version, or was linked
/// differently.
[[nodiscard]] bool mendsTheLibrary();

}  // namespace leitstand::detail
