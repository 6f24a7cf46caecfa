"""Problems with closed forms, solved by the engine: tests and the validation page share them."""
