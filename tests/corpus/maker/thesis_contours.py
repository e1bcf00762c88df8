def scenes():
    return []
