/// \file
/// A number that is typed while something else goes on, key by key: no field, no cursor.
#pragma once

#include <QString>
#include <optional>
#include <utility>

namespace ramure {

class TypedNumber
{
public:
    static constexpr int mostCharacters = 16;

    /// Digits, a point or comma (once), and the minus sign, which turns the sign round. \return whether the
    /// character belongs to numbers
    bool type(QChar character);
    /// Takes the last digit away, and with nothing left the sign. \return whether there was anything
    bool erase();
    void clear() { m_digits.clear(), m_negative = false; }
    [[nodiscard]] bool isEmpty() const { return m_digits.isEmpty() && !m_negative; }
    [[nodiscard]] QString text() const; ///< as typed, with a true minus sign and the language's decimal point
    /// Nothing as long as no digit is there.
    [[nodiscard]] std::optional<double> value() const;

private:
    QString m_digits; ///< and at most one point
    bool m_negative = false;
};

} // namespace ramure
