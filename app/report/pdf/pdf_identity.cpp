#include "app/report/pdf/pdf_identity.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <functional>

#include <QCryptographicHash>
#include <QDateTime>

namespace leitstand {
namespace {

/// Calls @p write with the value between each @p begin and the next @p end. The result replaces the value
/// when it is equally long.
void forEachValue(QByteArray& bytes, const char* begin, char end,
                  const std::function<QByteArray(const QByteArray&)>& write) {
    constexpr qsizetype Longest = 200;  // farther away it is a chance match in a picture's bytes
    const QByteArray mark(begin);
    for (qsizetype at = bytes.indexOf(mark); at >= 0; at = bytes.indexOf(mark, at + mark.size())) {
        const qsizetype first = at + mark.size(), last = bytes.indexOf(end, first);
        if (last < 0 || last - first > Longest) continue;
        const QByteArray value = write(bytes.mid(first, last - first));
        if (value.size() == last - first) bytes.replace(first, value.size(), value);
    }
}

QByteArray signedOffset(const QDateTime& local, const char* hours, const char* minutes) {
    const int offset = std::abs(local.offsetFromUtc()) / 60;
    return (local.offsetFromUtc() < 0 ? "-" : "+") + QByteArray::number(offset / 60).rightJustified(2, '0') +
           hours + QByteArray::number(offset % 60).rightJustified(2, '0') + minutes;
}

/// Returns @p moment in the form of @p old: "20261121201154Z", "20261121201154+01'00'".
QByteArray pdfDate(const QDateTime& moment, const QByteArray& old) {
    constexpr qsizetype Digits = 14;
    const bool utc = old.size() == Digits + 1 && old.endsWith('Z');
    const QDateTime shown = utc ? moment.toUTC() : moment.toLocalTime();
    const QByteArray text = shown.toString(QStringLiteral("yyyyMMddHHmmss")).toLatin1();
    if (utc) return text + 'Z';
    return old.size() > Digits ? text + signedOffset(shown, "'", "'") : text;
}

/// Returns @p moment in the form of @p old: "2026-11-21T20:11:54", then "Z", "+01:00" or nothing.
QByteArray xmpDate(const QDateTime& moment, const QByteArray& old) {
    constexpr qsizetype Digits = 19;
    const bool utc = old.size() == Digits + 1 && old.endsWith('Z');
    const QDateTime shown = utc ? moment.toUTC() : moment.toLocalTime();
    const QByteArray text = shown.toString(QStringLiteral("yyyy-MM-ddTHH:mm:ss")).toLatin1();
    if (utc) return text + 'Z';
    return old.size() > Digits ? text + signedOffset(shown, ":", "") : text;
}

bool isHex(char letter) {
    return (letter >= '0' && letter <= '9') || (letter >= 'a' && letter <= 'f') ||
           (letter >= 'A' && letter <= 'F');
}

/// Returns @p old with its hexadecimal digits replaced by @p digits, repeated as needed. Unchanged when it
/// contains characters other than those and @p more.
QByteArray withDigits(QByteArray old, const QByteArray& digits, const QByteArray& more) {
    const bool known =
        std::all_of(old.begin(), old.end(), [&](char c) { return isHex(c) || more.contains(c); });
    if (!known) return old;
    qsizetype next = 0;
    for (char& letter : old) {
        if (isHex(letter)) letter = digits[next++ % digits.size()];
    }
    return old;
}

void writeIdentities(QByteArray& bytes, const QByteArray& digits) {
    forEachValue(bytes, "/ID [", ']', [&](const QByteArray& old) { return withDigits(old, digits, " <>"); });
    forEachValue(bytes, "uuid:", '<', [&](const QByteArray& old) { return withDigits(old, digits, "-"); });
}

}  // namespace

QByteArray withIdentity(QByteArray bytes, Time created) {
    const auto since = std::chrono::floor<std::chrono::seconds>(created.time_since_epoch());
    const QDateTime moment = QDateTime::fromSecsSinceEpoch(since.count());
    for (const char* mark : {"/CreationDate (D:", "/ModDate (D:"})
        forEachValue(bytes, mark, ')', [&](const QByteArray& old) { return pdfDate(moment, old); });
    for (const char* mark : {"<xmp:CreateDate>", "<xmp:ModifyDate>", "<xmp:MetadataDate>"})
        forEachValue(bytes, mark, '<', [&](const QByteArray& old) { return xmpDate(moment, old); });
    writeIdentities(bytes, "0");
    writeIdentities(bytes, QCryptographicHash::hash(bytes, QCryptographicHash::Sha256).toHex());
    return bytes;
}

}  // namespace leitstand
