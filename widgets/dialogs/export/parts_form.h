/// \file
/// Which parts of trees an export writes: branches, leaves, fruit and their textures.
#pragma once

#include "core/qt/session/export/export_option.h"
#include <QWidget>

class QCheckBox;
class QLabel;

namespace ramure {

class OptionFields;

class PartsForm : public QWidget
{
    Q_OBJECT
public:
    /// \param fields get that of textures
    explicit PartsForm(OptionFields* fields, QWidget* parent = nullptr);

    [[nodiscard]] std::uint8_t parts() const; ///< bits of ExportPart
    void setParts(std::uint8_t parts);
    /// Ticks leaves and fruit, or unticks them.
    void setFoliage(bool ticked);
    void setBoxesEnabled(bool enabled);
    /// Tells that this format has no objects, unless leaves and fruit are ticked. Null: there is nothing to
    /// tell.
    void setMixing(const FileFormat* format);

signals:
    void changed();

private:
    QCheckBox* m_branches;
    QCheckBox* m_leaves;
    QCheckBox* m_apples;
    QLabel* m_note;
};

} // namespace ramure
