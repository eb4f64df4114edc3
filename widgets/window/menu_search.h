/// \file
/// A field on top of a menu: letters that are typed while the menu is open list what they find in it and in
/// the menus below.
#pragma once

#include <QList>
#include <QObject>
#include <QPointer>

class QAction;
class QLineEdit;
class QMenu;

namespace ramure {

class MenuSearch : public QObject
{
    Q_OBJECT
public:
    /// Most that is listed.
    static constexpr std::size_t most = 12;

    /// Belongs to the menu. \param menu whose other actions may come and go
    explicit MenuSearch(QMenu* menu);

    [[nodiscard]] QLineEdit* field() const { return m_field; }

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void find(const QString& typed);
    void putBack();

    QMenu* m_menu;
    QLineEdit* m_field;
    QAction* m_top;
    QList<QAction*> m_found;           ///< that stand for those that were found, made here
    QList<QPointer<QAction>> m_hidden; ///< while something is typed
};

} // namespace ramure
