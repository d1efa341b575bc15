#pragma once

namespace leitstand::detail {

/// Works around two defects of Fast DDS (2.9 of Debian 12, 3.1 of Debian 13) that end or block a process when
/// the last reader of a topic leaves. This program defines functions with the names of three functions of the
/// library. The library calls them instead of its own, and they call the originals.
///
/// A packet without a receiver: flow controllers send gathered samples without the writer's lock. If the last
/// reader has left by then, `SecurityManager::encode_rtps_message` fails an assertion that there is a
/// receiver. Here this is an ordinary error, and the packet is not sent.
///
/// Two locks in opposite orders: `StatefulWriter::matched_reader_remove` holds the list of addresses while
/// `check_acked_status` removes samples from the flow controller's queue, which takes the queue's lock. The
/// queue's thread holds that lock while it waits for the list to send. Both threads then wait for ever, and
/// so do all threads that write. Here the check is postponed until the list is free, and nobody else checks
/// in the meantime.
///
/// Returns false when the library does not call our functions, because it is another version or was linked
/// differently.
[[nodiscard]] bool mendsTheLibrary();

}  // namespace leitstand::detail
