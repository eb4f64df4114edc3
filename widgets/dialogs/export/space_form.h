/// \file
/// The axes and the unit of an exported mesh file.
#pragma once

#include "core/io/file_space.h"
#include <QWidget>

class QComboBox;
class QLabel;

namespace ramure {

class NumberField;

class SpaceForm : public QWidget
{
    Q_OBJECT
public:
    explicit SpaceForm(QWidget* parent = nullptr);

    void setSpace(const FileSpace& space);
    [[nodiscard]] FileSpace space() const;

signals:
    void changed();

protected:
    void changeEvent(QEvent* event) override;

private:
    void retranslate();

    QComboBox* m_up;
    QComboBox* m_unit;
    QLabel* m_times;
    NumberField* m_scale;
};

} // namespace ramure
