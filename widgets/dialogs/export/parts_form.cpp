#include "widgets/dialogs/export/parts_form.h"

#include "core/io/formats/file_format.h"
#include "widgets/base/named.h"
#include "widgets/base/texts/core_text.h"
#include "widgets/dialogs/export/option_fields.h"
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLabel>

namespace ramure {

PartsForm::PartsForm(OptionFields* fields, QWidget* parent)
    : QWidget(parent)
    , m_branches(new QCheckBox(tr("Branches"), this))
    , m_leaves(new QCheckBox(tr("Leaves"), this))
    , m_apples(new QCheckBox(tr("Fruit"), this))
{
    auto* boxes = new QHBoxLayout;
    boxes->setSpacing(16);
    for (QCheckBox* box : {m_branches, m_leaves, m_apples}) {
        box->setChecked(true);
        boxes->addWidget(box);
        connect(box, &QCheckBox::toggled, this, &PartsForm::changed);
    }
    boxes->addWidget(fields->make("texture", this));
    fields->of<QCheckBox>("texture")->setChecked(true);
    boxes->addStretch(1);
    m_note = named(new QLabel(this), "partsNote");
    m_note->setTextFormat(Qt::PlainText);
    m_note->setWordWrap(true);
    auto* layout = layoutOf<QVBoxLayout>(this, 6);
    layout->addLayout(boxes);
    layout->addWidget(m_note);
}

std::uint8_t PartsForm::parts() const
{
    return static_cast<std::uint8_t>((m_branches->isChecked() ? exportBranches : 0) |
                                     (m_leaves->isChecked() ? exportLeaves : 0) |
                                     (m_apples->isChecked() ? exportApples : 0));
}

void PartsForm::setParts(std::uint8_t parts)
{
    m_branches->setChecked(parts & exportBranches);
    m_leaves->setChecked(parts & exportLeaves);
    m_apples->setChecked(parts & exportApples);
}

void PartsForm::setFoliage(bool ticked)
{
    for (QCheckBox* box : {m_leaves, m_apples})
        box->setChecked(ticked);
}

void PartsForm::setBoxesEnabled(bool enabled)
{
    for (QCheckBox* box : {m_branches, m_leaves, m_apples})
        box->setEnabled(enabled);
}

void PartsForm::setMixing(const FileFormat* format)
{
    if (format)
        m_note->setText(
            tr("%1 has no objects: leaves and fruit would be mixed into the one closed mesh of the "
               "branches. Tick them to write them all the same.")
                .arg(coreText(format->name)));
    m_note->setVisible(format && !(m_leaves->isChecked() && m_apples->isChecked()));
}

} // namespace ramure
