#pragma once
/// Keeps what a disk would hold after a loss of power: copies of files as of their last flush, and the names in folders
/// as of theirs. All of it stands in the folder NILAS_FAULT_SHADOW:
///
/// - files/I: the content of the file with inode I when it was last flushed;
/// - kept/: further names of removed files, so that no other file gets their inode;
/// - journal: a line `F I PATH` for each flushed file, `D PATH` for each flushed folder, and after that `E I NAME` for
///   each of its files and `S I NAME` for each of its folders.

namespace nilas_faults {

/// A descriptor was flushed.
void note_flushed(int descriptor);
/// A file is about to lose its name. `path`: absolute.
void note_removed(const char* path);

}  // namespace nilas_faults
