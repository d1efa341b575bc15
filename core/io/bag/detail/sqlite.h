#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "core/base/result.h"

struct sqlite3;
struct sqlite3_stmt;

namespace leitstand::detail {

/// A prepared statement. Its results are valid until the next step() or reset().
class Statement {
public:
    Statement() = default;
    Statement(sqlite3* database, std::string_view sql);  ///< empty when it cannot be prepared

    [[nodiscard]] explicit operator bool() const { return m_statement != nullptr; }
    void bind(int index, std::int64_t value);
    void bind(int index, std::string_view text);             ///< copies the text
    void bind(int index, std::span<const std::byte> bytes);  ///< the bytes must exist until the step is done
    [[nodiscard]] int step();                                ///< SQLite's code: SQLITE_ROW, SQLITE_DONE ...
    /// Steps to the end and resets. Returns SQLITE_OK or the code of the error.
    [[nodiscard]] int run();
    void reset();

    [[nodiscard]] int type(int column) const;  ///< type of the value: SQLITE_INTEGER ...
    [[nodiscard]] std::int64_t integer(int column) const;
    [[nodiscard]] std::string text(int column) const;
    [[nodiscard]] std::span<const std::byte> bytes(int column) const;

private:
    struct Finalize {
        void operator()(sqlite3_stmt* statement) const;
    };
    std::unique_ptr<sqlite3_stmt, Finalize> m_statement;
};

/// A connection to a database file.
class Database {
public:
    Database() = default;
    /// Opens @p file with SQLite's @p flags, through the @p vfs with this name (empty: the default one).
    [[nodiscard]] static Result<Database> open(const std::string& file, int flags,
                                               const std::string& vfs = {});

    [[nodiscard]] explicit operator bool() const { return m_database != nullptr; }
    [[nodiscard]] sqlite3* handle() const { return m_database.get(); }
    [[nodiscard]] Statement prepare(std::string_view sql) const { return {m_database.get(), sql}; }
    /// Runs statements without results. Returns SQLITE_OK or the code of the error.
    [[nodiscard]] int run(const char* sql) const;
    /// Returns the first column of the first row of @p sql, or @p otherwise when there is no row.
    [[nodiscard]] std::int64_t number(std::string_view sql, std::int64_t otherwise) const;
    [[nodiscard]] std::string problem() const;  ///< SQLite's text for the last error
    /// Closes the connection; false when SQLite refuses.
    bool close();

private:
    struct Close {
        void operator()(sqlite3* database) const;
    };
    std::unique_ptr<sqlite3, Close> m_database;
};

}  // namespace leitstand::detail
