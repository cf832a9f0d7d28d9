//! Sessions with the adapter, message by message.
