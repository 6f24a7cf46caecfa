"""Which physical effects a question calls for, before it is solved."""
