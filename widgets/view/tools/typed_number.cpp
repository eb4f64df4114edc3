#include "widgets/view/tools/typed_number.h"

#include <QLocale>
#include <algorithm>

namespace ramure {

bool TypedNumber::type(QChar character)
{
    const ushort code = character.unicode();
    if (code == u'-' || code == u'\u2212') {
        m_negative = !m_negative;
        return true;
    }
    const bool point = code == u'.' || code == u',';
    if (!point && (code < u'0' || code > u'9'))
        return false;
    const bool full = m_digits.size() >= mostCharacters || (point && m_digits.contains(u'.'));
    if (!full)
        m_digits += point ? QLatin1Char('.') : character;
    return true; // one too many is no other key either
}

bool TypedNumber::erase()
{
    if (!m_digits.isEmpty()) {
        m_digits.chop(1);
        return true;
    }
    return std::exchange(m_negative, false);
}

QString TypedNumber::text() const
{
    QString digits = m_digits;
    digits.replace(u'.', QLocale().decimalPoint());
    return (m_negative ? QString(QChar(0x2212)) : QString()) + digits;
}

std::optional<double> TypedNumber::value() const
{
    bool good = false;
    const double size = QLocale::c().toDouble(m_digits, &good);
    const bool any =
        std::any_of(m_digits.begin(), m_digits.end(), [](QChar c) { return c != QLatin1Char('.'); });
    if (!good || !any)
        return std::nullopt;
    return m_negative ? -size : size;
}

} // namespace ramure
