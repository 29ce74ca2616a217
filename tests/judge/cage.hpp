// What a learner's program may not do to the machine it runs on.
#pragma once

namespace nutshell::judge {

/// From here on this process, and what it becomes, may start no process and send signals to itself only:
/// the kernel answers "not permitted". Where the kernel has no such filter, nothing happens.
void close_cage();

}  // namespace nutshell::judge
