#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace harmos::base {

/// A matrix that is written and read column by column, zero at first, and not needed in between: in memory, or in a
/// file.
///
/// The file has no name once it is open, so that nothing is left of it when the process ends, however it does.
class ColumnStore {
 public:
  /// No columns.
  ColumnStore();
  /// rows x columns in a file in `folder`; in memory where that is empty. Throws Error naming the folder when the file
  /// cannot be made.
  ColumnStore(int rows, int columns, const std::string& folder);
  /// Takes the columns of another one, of which nothing but the end may be asked then.
  ColumnStore(ColumnStore&& other) noexcept;
  /// The same; its own columns are lost.
  ColumnStore& operator=(ColumnStore&& other) noexcept;
  ~ColumnStore();

  int rows() const { return rows_; }        ///< of every column
  int columns() const { return columns_; }  ///< in all
  /// Puts rows() values into a column. Throws Error when the disk is full.
  void write(int column, const double* values);
  /// The values of a column; valid until the next read() or write(). Throws Error when the file cannot be read.
  const double* read(int column) const;

 private:
  class File;
  std::size_t at(int column) const { return static_cast<std::size_t>(rows_) * static_cast<std::size_t>(column); }

  int rows_ = 0, columns_ = 0;
  mutable std::vector<double> values_;  // all, or a column that was read
  std::unique_ptr<File> file_;          // null: none
};

}  // namespace harmos::base
