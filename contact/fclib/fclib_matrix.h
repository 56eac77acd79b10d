#pragma once
/// A sparse matrix of an FCLIB file: group with m, n, nzmax, nz, p, i, x.
///
/// nz >= 0: nz triplets; nz = -1: compressed columns; nz = -2: compressed rows. nzmax may exceed what is stored.
/// The format's header documents triplets as p = rows, i = columns; files written through Siconos hold p = columns,
/// i = rows. Which it is follows from the bounds, then from columns that would stay empty, and if neither tells
/// (a symmetric matrix mostly), it is taken to be the second, which is what existing files hold.
#include <string>
#include <vector>

#include "core/hdf5/hdf5_file.h"

namespace nilas::contact {

struct MatrixEntry {
  int row = 0, column = 0;
  double value = 0;
};

/// The entries that are not zero, in the order of the file; those of one place add up. The group must declare rows x
/// columns. Throws InputError naming the dataset at fault.
std::vector<MatrixEntry> read_matrix(const hdf5::Hdf5Reader& file, const std::string& group, int rows, int columns);

/// True where the group exists and has rows and columns.
bool has_matrix(const hdf5::Hdf5Reader& file, const std::string& group);

/// Adds the group, in compressed columns. `entries` each at their own place.
void add_matrix(hdf5::Hdf5Writer& file, const std::string& group, int rows, int columns,
                std::vector<MatrixEntry> entries);

}  // namespace nilas::contact
