#pragma once

/// What the machine can give, measured in the same run as what is compared with it.
namespace pinball::bench {

/// Sustained memory bandwidth of a triad a = b + s c over arrays far larger than the caches, counting the two reads,
/// the write and the read for ownership of the written line; best of several runs [byte/s].
double memory_bandwidth(int threads);

/// Multiply-adds of independent double packs in registers, two operations each; best of several runs [operation/s].
double arithmetic_peak(int threads);

}  // namespace pinball::bench
