## Файлы
command-open = Открыть…
command-save-as = Сохранить как…
dialog-open = Открыть сцену или модель
dialog-save-as = Сохранить сцену как
dialog-add-model = Добавить модель
dialog-export = Сохранить изображение
dialog-unsaved = Несохранённые изменения
dialog-replace = Файл уже есть
button-open = Открыть
button-save = Сохранить
button-add = Добавить
button-export = Сохранить
button-cancel = Отмена
button-browse = Обзор…
button-browse-tip = Открыть диалог файлов системы
button-do-not-save = Не сохранять
button-replace = Заменить
button-other-name = Другое имя…
files-scenes-and-models = Сцены и модели
files-scenes = Сцены
files-models = Модели
files-pictures = Изображения
path-field = Путь
folder-above = На папку выше
files-saving = Сохраняется…
files-reading = Читается…
no-system-dialog = Диалог файлов системы не отвечает. Введите путь или выберите из списка.
folder-not-read = Папка не читается: { $folder }: { $why }
unsaved-question = В сцене «{ $scene }» есть изменения, которых нет ни в одном файле. Сохранить их?
replace-question = Файл { $path } уже есть. Заменить его?
window-title-changed = { $path } * — Луч
window-title = { $path } — Луч

## Добавление
menu-add = Добавить
command-add-model = Модель…
command-add-camera = Камера с этого вида
new-sphere-name = Сфера
new-cube-name = Куб
new-wall-name = Стена
new-camera-name = Камера { $number }
notice-model-not-added = Модель не добавлена

## Недавние файлы и перетаскивание
menu-recent = Недавние
drop-scene = Отпустите, чтобы открыть сцену
drop-model = Отпустите, чтобы добавить модель; с Shift — чтобы открыть её отдельно
drop-model-alone = Отпустите, чтобы открыть модель отдельно
drop-anything = Отпустите, чтобы открыть сцену или добавить модель
drop-nothing = Открываются только сцены (.toml) и модели (.obj)
notice-not-opened = Не открыто: можно открыть одну сцену (.toml) или модели (.obj)

## Изображения в файлы
command-export = Сохранить изображение…
export-png-8 = PNG, 8 бит
export-png-16 = PNG, 16 бит
export-exr = EXR, линейный свет, 32 бита
export-too-large = Изображению нужно памяти: { $needed }, можно занять: { $limit }. Выберите размер поменьше.
export-busy = Другое изображение ещё в работе; это начнётся после него.
export-progress = Ход сохранения изображения
export-writing = Файл записывается…
export-of = В файл: { $name }
export-cancel = Прервать сохранение
notice-exported = Изображение сохранено
notice-not-exported = Изображение не сохранено
notice-export-cancelled = Сохранение изображения прервано
dialog-stop-export = Изображение ещё в работе
stop-export-question = Изображение для файла ещё не готово. Выйти, не дождавшись его?
button-quit = Выйти

## Восстановление
dialog-recover = Несохранённые сцены
recover-what = «Луч» завершился, не сохранив эти сцены.
button-recover = Восстановить
button-discard = Удалить
button-later = Позже
button-later-tip = Они будут предложены при следующем запуске
ago-moments = Записана меньше минуты назад
ago-minutes = { $minutes ->
    [one] Записана { $minutes } минуту назад
    [few] Записана { $minutes } минуты назад
   *[other] Записана { $minutes } минут назад
}
ago-hours = { $hours ->
    [one] Записана { $hours } час назад
    [few] Записана { $hours } часа назад
   *[other] Записана { $hours } часов назад
}
ago-days = { $days ->
    [one] Записана { $days } день назад
    [few] Записана { $days } дня назад
   *[other] Записана { $days } дней назад
}
notice-not-kept = Автосохранение не удалось: сохраните сцену

## Камеры
command-remove-camera = Удалить камеру
dialog-rename-camera = Переименовать камеру…
button-rename = Переименовать
