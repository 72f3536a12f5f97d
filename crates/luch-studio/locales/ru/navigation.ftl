## Обзор
command-frame = Показать выделенное целиком
shortcuts-keys-of-picture = Клавиши, когда выбрано изображение
key-cameras = 1 … 9
key-cameras-does = Смотреть этой камерой
key-orbit = Стрелки
key-orbit-does = Осмотреть выделенное со всех сторон
key-pan = Shift и стрелки
key-pan-does = Сдвинуть камеру вбок
key-dolly = + и −
key-dolly-does = Приблизить или отдалить камеру
