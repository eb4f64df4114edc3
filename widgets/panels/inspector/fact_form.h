/// \file
/// Two columns of facts: a name and a value that can be marked and copied.
#pragma once

#include <QWidget>
#include <vector>

class QGridLayout;
class QLabel;

namespace ramure {

class FactForm : public QWidget
{
    Q_OBJECT
public:
    explicit FactForm(int rows, QWidget* parent = nullptr);

    [[nodiscard]] int rowCount() const { return static_cast<int>(m_values.size()); }
    void setName(int row, const QString& name, const QString& help = {});
    void setValue(int row, const QString& plainText);
    /// A value with links (\<a href="..."\>), followed by mouse and by Tab and Enter.
    void setRichValue(int row, const QString& html);
    [[nodiscard]] QString value(int row) const;
    [[nodiscard]] QString name(int row) const;

signals:
    void linkActivated(const QString& target);

private:
    std::vector<QLabel*> m_names;
    std::vector<QLabel*> m_values;
};

} // namespace ramure
