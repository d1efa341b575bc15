#include "core/io/bag/detail/sqlite.h"

#include <sqlite3.h>

namespace leitstand::detail {

void Statement::Finalize::operator()(sqlite3_stmt* statement) const {
    sqlite3_finalize(statement);
}

Statement::Statement(sqlite3* database, std::string_view sql) {
    sqlite3_stmt* statement = nullptr;
    sqlite3_prepare_v2(database, sql.data(), static_cast<int>(sql.size()), &statement, nullptr);
    m_statement.reset(statement);
}

void Statement::bind(int index, std::int64_t value) {
    sqlite3_bind_int64(m_statement.get(), index, value);
}

void Statement::bind(int index, std::string_view text) {
    sqlite3_bind_text64(m_statement.get(), index, text.data(), text.size(), SQLITE_TRANSIENT, SQLITE_UTF8);
}

void Statement::bind(int index, std::span<const std::byte> bytes) {
    if (bytes.empty()) {
        sqlite3_bind_zeroblob(m_statement.get(), index, 0);  // a null pointer would mean NULL
    } else {
        sqlite3_bind_blob64(m_statement.get(), index, bytes.data(), bytes.size(), SQLITE_STATIC);
    }
}

int Statement::step() {
    return sqlite3_step(m_statement.get());
}

int Statement::run() {
    int code = sqlite3_step(m_statement.get());
    while (code == SQLITE_ROW) code = sqlite3_step(m_statement.get());
    sqlite3_reset(m_statement.get());
    return code == SQLITE_DONE ? SQLITE_OK : code;
}

void Statement::reset() {
    sqlite3_reset(m_statement.get());
}

int Statement::type(int column) const {
    return sqlite3_column_type(m_statement.get(), column);
}

std::int64_t Statement::integer(int column) const {
    return sqlite3_column_int64(m_statement.get(), column);
}

std::string Statement::text(int column) const {
    const auto* text = sqlite3_column_text(m_statement.get(), column);
    if (text == nullptr) return {};
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(m_statement.get(), column));
    return {reinterpret_cast<const char*>(text), size};
}

std::span<const std::byte> Statement::bytes(int column) const {
    const void* bytes = sqlite3_column_blob(m_statement.get(), column);
    const auto size = static_cast<std::size_t>(sqlite3_column_bytes(m_statement.get(), column));
    return {static_cast<const std::byte*>(bytes), bytes == nullptr ? 0 : size};
}

void Database::Close::operator()(sqlite3* database) const {
    sqlite3_close_v2(database);
}

Result<Database> Database::open(const std::string& file, int flags, const std::string& vfs) {
    sqlite3* handle = nullptr;
    const int code = sqlite3_open_v2(file.c_str(), &handle, flags, vfs.empty() ? nullptr : vfs.c_str());
    Database database;
    database.m_database.reset(handle);  // must be closed even when opening failed
    if (code != SQLITE_OK) return Error{database.problem()};
    sqlite3_extended_result_codes(handle, 1);
    return database;
}

int Database::run(const char* sql) const {
    return sqlite3_exec(m_database.get(), sql, nullptr, nullptr, nullptr);
}

std::int64_t Database::number(std::string_view sql, std::int64_t otherwise) const {
    Statement statement = prepare(sql);
    if (!statement || statement.step() != SQLITE_ROW || statement.type(0) == SQLITE_NULL) return otherwise;
    return statement.integer(0);
}

std::string Database::problem() const {
    return m_database ? sqlite3_errmsg(m_database.get()) : "out of memory";
}

bool Database::close() {
    if (!m_database) return true;
    if (sqlite3_close(m_database.get()) != SQLITE_OK) return false;
    (void)m_database.release();
    return true;
}

}  // namespace leitstand::detail
