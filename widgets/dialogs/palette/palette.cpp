#include "widgets/dialogs/palette/palette.h"

#include "widgets/base/named.h"
#include "widgets/base/theme/icons.h"
#include "widgets/dialogs/palette/palette_delegate.h"
#include "widgets/dialogs/palette/palette_model.h"
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QVBoxLayout>
#include <algorithm>

namespace ramure {
namespace {

constexpr int paletteWidth = 640, listHeight = 384, top = 48;

} // namespace

Palette::Palette(QWidget* parent)
    : QFrame(parent, Qt::Popup)
    , m_model(new PaletteModel(this))
    , m_field(new QLineEdit(this))
    , m_list(new QListView(this))
    , m_none(new QLabel(tr("Nothing is called like this."), this))
{
    setObjectName(QStringLiteral("palette"));
    build();
    m_field->setPlaceholderText(tr("Commands, parameters and the handbook"));
    m_field->setAccessibleName(tr("Find a command, a parameter or a page of the handbook"));
    m_list->setAccessibleName(tr("Found"));
    connect(m_field, &QLineEdit::textEdited, this, [this](const QString& typed) {
        m_model->setTyped(typed);
        showFound();
    });
    connect(m_list, &QListView::clicked, this, &Palette::chooseCurrent);
}

void Palette::build()
{
    m_field->setObjectName(QStringLiteral("paletteField"));
    m_field->addAction(icon("search"), QLineEdit::LeadingPosition);
    m_field->installEventFilter(this);
    m_list->setObjectName(QStringLiteral("paletteList"));
    m_list->setModel(m_model);
    m_list->setItemDelegate(new PaletteDelegate(m_list));
    m_list->setUniformItemSizes(true);
    m_list->setFocusPolicy(Qt::NoFocus); // the field keeps the keys
    m_list->setFocusProxy(m_field);
    m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    m_list->setMouseTracking(true);
    m_list->setFixedHeight(listHeight);
    m_none->setObjectName(QStringLiteral("dim"));
    m_none->setAlignment(Qt::AlignCenter);
    m_none->setFixedHeight(listHeight);
    auto* hint = new QLabel(tr("Up and Down choose, Return runs or shows it, Esc closes"), this);
    hint->setObjectName(QStringLiteral("dim"));
    auto* layout = layoutOf<QVBoxLayout>(this, 6, {8, 8, 8, 6});
    layout->addWidget(m_field);
    layout->addWidget(m_list);
    layout->addWidget(m_none);
    layout->addWidget(hint);
    setFixedWidth(paletteWidth);
}

void Palette::open(std::vector<PaletteItem> items, const QStringList& recent)
{
    m_model->setItems(std::move(items), recent);
    m_field->clear();
    showFound();
    place();
    show();
    m_field->setFocus(Qt::PopupFocusReason);
}

void Palette::place()
{
    adjustSize();
    const QWidget* window = parentWidget()->window();
    move(window->mapToGlobal(QPoint((window->width() - paletteWidth) / 2, top)));
}

void Palette::showFound()
{
    const bool any = m_model->rowCount() > 0;
    m_list->setVisible(any);
    m_none->setVisible(!any);
    m_list->setCurrentIndex(m_model->index(0, 0));
    m_list->scrollToTop();
}

void Palette::chooseCurrent()
{
    const PaletteItem* found = m_model->item(m_list->currentIndex().row());
    if (!found || !found->enabled)
        return;
    const PaletteItem item = *found; // the list may change while it is done
    close();
    emit chosen(item);
}

bool Palette::eventFilter(QObject* watched, QEvent* event)
{
    if (watched != m_field || event->type() != QEvent::KeyPress)
        return QFrame::eventFilter(watched, event);
    const auto* key = static_cast<QKeyEvent*>(event);
    const int rows = m_model->rowCount(), page = m_list->height() / std::max(1, m_list->sizeHintForRow(0));
    const int row = m_list->currentIndex().row();
    const auto go = [this, rows](int to) {
        m_list->setCurrentIndex(m_model->index(std::clamp(to, 0, std::max(0, rows - 1)), 0));
        return true;
    };
    switch (key->key()) {
    case Qt::Key_Down:
        return go(row + 1 < rows ? row + 1 : 0);
    case Qt::Key_Up:
        return go(row > 0 ? row - 1 : rows - 1);
    case Qt::Key_PageDown:
        return go(row + page);
    case Qt::Key_PageUp:
        return go(row - page);
    case Qt::Key_Return:
    case Qt::Key_Enter:
        chooseCurrent();
        return true;
    default:
        return false;
    }
}

} // namespace ramure
